// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/base/thread_team.h"
#include "core/filter/block_weights.h"
#include "core/filter/particle_set.h"

#include <Eigen/Core>

namespace dewpoint::filter {

/// Resampling of CONDENSATION (Isard & Blake 1998): for each new particle an independent uniform
/// draw, looked up in the cumulative weights. Unbiased; a particle of weight zero is never picked.
/// The weights need not sum to 1, but at least one must be positive.
///
/// The draws are made in rising order (SortedDraws), so that ancestors rise too and memory is read
/// from one end to the other. The ancestors are those of a binary search for each draw in
/// CumulativeWeights.
class MultinomialResampling {
public:
  void ancestors(const Eigen::ArrayXd& weights, Eigen::Index count, const RandomStream& stream,
                 Ancestors& picked) const;
  /// Shared by several threads; the same to the bit for any number of them.
  void ancestors(const BlockWeights& weights, Eigen::Index count, const RandomStream& stream,
                 ThreadTeam& team, Ancestors& picked) const;
};

} // namespace dewpoint::filter
