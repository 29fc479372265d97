// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/block_weights.h"
#include "core/filter/prefix_sums.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace dewpoint::filter {

/// Running sums of the weights, never falling, and the same for any number of threads: summed in
/// the stretches of prefix_sums.h. With up to kStretch particles they are the plain sums.
class CumulativeWeights {
public:
  /// The weights must stay where they are.
  void build(const BlockWeights& weights);
  void build(const Eigen::ArrayXd& weights);

  std::int64_t count() const { return count_; }
  double total() const { return before_.back(); }
  /// The block of kPrefixBlock particles that a draw below total() falls into.
  std::int64_t blockOf(double draw) const;
  /// Writes the cumulative weights of a block and returns how many there are.
  std::int64_t write(std::int64_t block, double* cumulative) const;

private:
  void reset(const double* weights, std::int64_t count);
  void append(const StretchSums& sums, double factor);

  const double* weights_ = nullptr;
  std::int64_t count_ = 0;
  std::vector<double> factors_; ///< of the weights of every block
  std::vector<double> before_; ///< the weights before every stretch, kAbreast per block, and of all
};

} // namespace dewpoint::filter
