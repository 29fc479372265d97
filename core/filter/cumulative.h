// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/thread_team.h"
#include "core/filter/prefix_sums.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dewpoint {

/// Cumulative weights, in the stretches of prefix_sums.h. They never fall. With up to kStretch
/// particles they are the plain sums.
class CumulativeWeights {
public:
  /// Sums up each stretch; the weights must stay where they are.
  void build(const Eigen::ArrayXd& weights, ThreadTeam& team);

  std::int64_t count() const { return count_; }
  double total() const { return before_.back(); }
  /// The block of kPrefixBlock particles that a draw below total() falls into.
  std::int64_t blockOf(double draw) const;
  /// Writes the cumulative weights of a block and returns how many there are.
  std::int64_t write(std::int64_t block, double* cumulative) const;

private:
  const double* weights_ = nullptr;
  std::int64_t count_ = 0;
  std::vector<double> before_; ///< the weights before every stretch, kAbreast per block, and of all
};

} // namespace dewpoint
