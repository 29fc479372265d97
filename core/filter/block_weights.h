// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/block_sums.h"
#include "core/filter/prefix_sums.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dewpoint::filter {

/// Linear weights that sum to 1, by blocks of kSumBlock particles: within a block they are kept
/// relative to its largest, so that they are written once, when only the block itself is known.
class BlockWeights {
public:
  void resize(std::int64_t count);
  /// Sets the weights of the block that begins at particle `begin` from its `length` log weights;
  /// one that is not finite counts as weight zero. Different blocks may be set at the same time.
  void setBlock(std::int64_t begin, std::int64_t length, const double* logWeights);
  /// After all blocks: makes the sum 1. If no log weight was finite, returns false and makes all
  /// weights equal.
  bool finish();
  /// Makes all weights equal.
  void setEqual();

  std::int64_t count() const { return relative_.size(); }
  double operator[](std::int64_t particle) const {
    return relative_[particle] * factor(particle / kSumBlock);
  }
  Eigen::ArrayXd all() const;

  /// Weights relative to the largest of their block, from particle `begin` on.
  const double* relative(std::int64_t begin) const { return relative_.data() + begin; }
  /// What turns them into weights.
  double factor(std::int64_t block) const { return blocks_[std::size_t(block)].factor; }
  /// Their sums within each stretch of the block.
  const StretchSums& sums(std::int64_t block) const { return blocks_[std::size_t(block)].sums; }

private:
  struct Block {
    double largest = 0.0; ///< log weight
    double factor = 0.0;
    StretchSums sums{};
  };
  void sumUp(std::int64_t begin, std::int64_t length);

  Eigen::ArrayXd relative_;
  std::vector<Block> blocks_;
};

} // namespace dewpoint::filter
