// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/cumulative.h"

#include <algorithm>

namespace dewpoint::filter {

void CumulativeWeights::reset(const double* weights, std::int64_t count) {
  weights_ = weights;
  count_ = count;
  factors_.clear();
  before_.assign(1, 0.0);
}

void CumulativeWeights::append(const StretchSums& sums, double factor) {
  factors_.push_back(factor);
  for (const double sum : sums) {
    before_.push_back(before_.back() + factor * sum);
  }
}

void CumulativeWeights::compute(const BlockWeights& weights) {
  reset(weights.relativeWeightsFrom(0), weights.particleCount());
  for (std::int64_t block = 0; block * kPrefixBlock < count_; ++block) {
    append(weights.stretchSums(block), weights.blockFactor(block));
  }
}

void CumulativeWeights::compute(const Eigen::ArrayXd& weights) {
  reset(weights.data(), weights.size());
  for (std::int64_t begin = 0; begin < count_; begin += kPrefixBlock) {
    append(prefixSums(weights_ + begin, std::min(kPrefixBlock, count_ - begin),
                      [](std::int64_t /*index*/, double /*sum*/) {}),
           1.0);
  }
}

std::int64_t CumulativeWeights::blockOfDraw(double draw) const {
  const auto end = std::upper_bound(before_.begin() + 1, before_.end(), draw);
  return (end - before_.begin() - 1) / kLanes;
}

std::int64_t CumulativeWeights::writeBlock(std::int64_t block, double* cumulative) const {
  const double* before = before_.data() + block * kLanes;
  const double factor = factors_[std::size_t(block)];
  const std::int64_t begin = block * kPrefixBlock;
  const std::int64_t length = std::min(kPrefixBlock, count_ - begin);
  constexpr std::int64_t kLine = 8; // numbers
  for (std::int64_t i = begin + length; i < std::min(begin + 2 * length, count_); i += kLine) {
    __builtin_prefetch(weights_ + i); // of the next block, likely asked for next
  }
  prefixSums(weights_ + begin, length, [&](std::int64_t index, double sum) {
    cumulative[index] = before[index / kStretch] + factor * sum;
  });
  return length;
}

} // namespace dewpoint::filter
