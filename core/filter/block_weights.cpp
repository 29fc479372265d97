// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/block_weights.h"

#include "core/base/elementary.h"
#include "core/filter/log_weights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace dewpoint::filter {

static_assert(kPrefixBlock == kSumBlock);

void BlockWeights::resize(std::int64_t count) {
  relative_.resize(count);
  blocks_.resize(static_cast<std::size_t>((count + kSumBlock - 1) / kSumBlock));
}

void BlockWeights::setBlock(std::int64_t begin, std::int64_t length, const double* logWeights) {
  Block& block = blocks_[std::size_t(begin / kSumBlock)];
  block.largestLogWeight = largestLogWeight(logWeights, length);
  if (std::isfinite(block.largestLogWeight)) {
    relativeWeights(logWeights, length, block.largestLogWeight, relative_.data() + begin);
  } else {
    relative_.segment(begin, length).setZero();
  }
  sumUp(begin, length);
}

void BlockWeights::sumUp(std::int64_t begin, std::int64_t length) {
  blocks_[std::size_t(begin / kSumBlock)].sums =
      prefixSums(relative_.data() + begin, length, [](std::int64_t /*index*/, double /*sum*/) {});
}

bool BlockWeights::normalize() {
  double largest = -std::numeric_limits<double>::infinity();
  for (const Block& block : blocks_) {
    largest = std::max(largest, block.largestLogWeight);
  }
  if (!std::isfinite(largest)) {
    makeEqual();
    return false;
  }
  double total = 0.0;
  for (Block& block : blocks_) {
    block.factor = exponential(block.largestLogWeight - largest);
    total += block.factor * std::accumulate(block.sums.begin(), block.sums.end(), 0.0);
  }
  for (Block& block : blocks_) {
    block.factor /= total;
  }
  return true;
}

void BlockWeights::makeEqual() {
  relative_.setOnes();
  for (std::int64_t begin = 0; begin < particleCount(); begin += kSumBlock) {
    sumUp(begin, std::min(kSumBlock, particleCount() - begin));
    blocks_[std::size_t(begin / kSumBlock)].factor = 1.0 / static_cast<double>(particleCount());
  }
}

Eigen::ArrayXd BlockWeights::linearWeights() const {
  Eigen::ArrayXd weights(particleCount());
  for (std::int64_t i = 0; i < particleCount(); ++i) {
    weights[i] = (*this)[i];
  }
  return weights;
}

} // namespace dewpoint::filter
