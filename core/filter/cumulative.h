// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/block_weights.h"
#include "core/filter/prefix_sums.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace dewpoint::filter {

/// Cumulative sums of the weights, in particle order. The sums never decrease. The weights are
/// summed in stretches: fixed runs of kStretch particles (prefix_sums.h). The sums are therefore
/// the same for any number of threads. For up to kStretch particles, they are plain running sums.
class CumulativeWeights {
public:
  /// Computes the sums. The weights are not copied, so they must stay in memory unchanged.
  void compute(const BlockWeights& weights);
  void compute(const Eigen::ArrayXd& weights);

  std::int64_t particleCount() const { return count_; }
  /// Returns the sum of all weights.
  double total() const { return before_.back(); }
  /// Returns the index of the block of kPrefixBlock particles into which a draw below total()
  /// falls.
  std::int64_t blockOfDraw(double draw) const;
  /// Writes the cumulative weights of a block and returns their number.
  std::int64_t writeBlock(std::int64_t block, double* cumulative) const;

private:
  void reset(const double* weights, std::int64_t count);
  void append(const StretchSums& sums, double factor);

  const double* weights_ = nullptr;
  std::int64_t count_ = 0;
  std::vector<double> factors_; ///< factor of the weights of each block
  std::vector<double> before_;  ///< sums before each stretch, then the total
};

} // namespace dewpoint::filter
