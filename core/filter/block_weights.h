// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/block_sums.h"
#include "core/filter/prefix_sums.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dewpoint::filter {

/// Linear weights that sum to 1, stored in blocks of kSumBlock particles. Within a block, weights
/// are stored relative to the largest weight of the block. The stored values do not depend on other
/// blocks, so each is written only once.
class BlockWeights {
public:
  /// Sets the number of particles. The weights are undefined until setBlock() or makeEqual() sets
  /// them.
  void resize(std::int64_t count);
  /// Sets the weights of the block that begins at particle `begin` from its `length` log weights. A
  /// log weight that is not finite becomes weight zero. Different threads may set different blocks
  /// at the same time.
  void setBlock(std::int64_t begin, std::int64_t length, const double* logWeights);
  /// Normalizes the weights so that they sum to 1. Call it after all blocks have been set. If no
  /// log weight was finite, all weights become equal and the function returns false.
  bool normalize();
  /// Makes all weights equal.
  void makeEqual();

  std::int64_t particleCount() const { return relative_.size(); }
  double operator[](std::int64_t particle) const {
    return relative_[particle] * blockFactor(particle / kSumBlock);
  }
  /// Returns the weights of all particles, which sum to 1.
  Eigen::ArrayXd linearWeights() const;

  /// Returns the weights from particle `begin` on, relative to the largest weight in their block.
  const double* relativeWeightsFrom(std::int64_t begin) const { return relative_.data() + begin; }
  /// Returns the factor that converts the relative weights of a block to weights that sum to 1 over
  /// the set.
  double blockFactor(std::int64_t block) const { return blocks_[std::size_t(block)].factor; }
  /// Returns the sums of the relative weights of a block, one for each of its stretches (runs of
  /// kStretch particles).
  const StretchSums& stretchSums(std::int64_t block) const {
    return blocks_[std::size_t(block)].sums;
  }

private:
  struct Block {
    double largestLogWeight = 0.0;
    double factor = 0.0; ///< converts relative weights to weights that sum to 1 over the set
    StretchSums sums{};
  };
  void sumUp(std::int64_t begin, std::int64_t length);

  Eigen::ArrayXd relative_;
  std::vector<Block> blocks_;
};

} // namespace dewpoint::filter
