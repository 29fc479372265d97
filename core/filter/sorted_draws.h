// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/filter/prefix_sums.h"

#include <cstdint>
#include <vector>

namespace dewpoint::filter {

/// Independent uniform draws from [0, total), in rising order, without sorting: n such draws lie
/// like the partial sums of n + 1 independent exponential spacings, divided by their sum (Devroye
/// 1986, "Non-Uniform Random Variate Generation", section V.3.1).
///
/// Spacings belong to blocks of kBlock. The sum of a block's spacings is independent of their
/// ratios; so it is drawn first, from its Gamma distribution, and a block can be had without the
/// ones before it.
class SortedDraws {
public:
  static constexpr std::int64_t kBlock = kPrefixBlock;

  /// `count` draws, at least one; `total` must be positive.
  SortedDraws(const RandomStream& stream, std::int64_t count, double total);

  std::int64_t count() const { return count_; }
  std::int64_t blockCount() const { return (count_ + kBlock - 1) / kBlock; }
  /// Writes draws kBlock * block and following and returns how many there are, at most kBlock.
  std::int64_t write(std::int64_t block, double* draws) const;

private:
  RandomStream stream_;
  std::int64_t count_;
  double scale_ = 0.0;         ///< from sums of spacings to draws
  double largest_ = 0.0;       ///< the largest number below the total
  std::vector<double> begins_; ///< the spacings before every block, and of all
};

} // namespace dewpoint::filter
