// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/base/thread_team.h"
#include "core/filter/block_weights.h"
#include "core/filter/particle_set.h"

#include <Eigen/Core>

namespace dewpoint::filter {

/// Multinomial resampling as in CONDENSATION (Isard & Blake 1998): each new particle takes an
/// independent uniform draw, which is looked up in the cumulative weights. The method is unbiased.
/// A particle with weight zero is never picked. The weights need not sum to 1, but at least one
/// must be positive.
///
/// The draws are generated in ascending order (SortedDraws). The ancestors are therefore also
/// ascending, and memory is read from front to back. The result is the same as with a binary search
/// in CumulativeWeights for each draw.
class MultinomialResampling {
public:
  void drawAncestors(const Eigen::ArrayXd& weights, Eigen::Index count, const RandomStream& stream,
                     Ancestors& picked) const;
  /// Picks ancestors on several threads. The result is bit-identical for any number of threads.
  void drawAncestors(const BlockWeights& weights, Eigen::Index count, const RandomStream& stream,
                     ThreadTeam& team, Ancestors& picked) const;
};

} // namespace dewpoint::filter
