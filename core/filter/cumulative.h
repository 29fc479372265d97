// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/thread_team.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace dewpoint {

/// Cumulative weights, defined so that threads and processors of any number give the same bits:
/// summed up in order within each stretch of kStretch particles, then moved by the sum of the
/// stretches before. They never fall. With up to kStretch particles they are the plain sums.
class CumulativeWeights {
public:
  static constexpr std::int64_t kStretch = 1024;

  /// Sums up each stretch; the weights must stay where they are.
  void build(const Eigen::ArrayXd& weights, ThreadTeam& team);

  double total() const { return before_.back(); }
  /// The sum of all weights before a particle at the beginning of a stretch (or behind the end).
  double before(std::int64_t particle) const {
    return before_[static_cast<std::size_t>((particle + kStretch - 1) / kStretch)];
  }
  /// Writes the cumulative weights of particles begin to end - 1; `begin` begins a stretch.
  void write(std::int64_t begin, std::int64_t end, double* cumulative) const;

private:
  const double* weights_ = nullptr;
  std::vector<double> before_; ///< of every stretch, and of all
};

} // namespace dewpoint
