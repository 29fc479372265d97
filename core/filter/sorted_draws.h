// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/filter/prefix_sums.h"

#include <cstdint>
#include <vector>

namespace dewpoint::filter {

/// Independent uniform draws from [0, total), generated in ascending order without sorting. Method:
/// draw n + 1 independent exponential spacings. Their first n partial sums, divided by the sum of
/// all spacings and multiplied by `total`, are distributed like n sorted uniform draws (Devroye
/// 1986, "Non-Uniform Random Variate Generation", section V.3.1).
///
/// The spacings are grouped in blocks of kBlockSize. The sum of the spacings in a block is
/// independent of their ratios. The sums of all blocks are therefore drawn first, from their gamma
/// distributions. After that, each block can be generated without the blocks before it.
class SortedDraws {
public:
  static constexpr std::int64_t kBlockSize = kPrefixBlock;

  /// Prepares `count` draws, at least one. `total` must be positive.
  SortedDraws(const RandomStream& stream, std::int64_t count, double total);

  std::int64_t drawCount() const { return count_; }
  std::int64_t blockCount() const { return (count_ + kBlockSize - 1) / kBlockSize; }
  /// Writes the draws of a block, beginning with draw kBlockSize * block, and returns their number,
  /// at most kBlockSize.
  std::int64_t writeBlock(std::int64_t block, double* draws) const;

private:
  RandomStream stream_;
  std::int64_t count_;
  double scale_ = 0.0;         ///< converts sums of spacings to draws
  double largest_ = 0.0;       ///< largest number below the total
  std::vector<double> begins_; ///< sum of spacings before each block, then the sum of all
};

} // namespace dewpoint::filter
