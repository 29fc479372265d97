// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/cumulative.h"

#include <algorithm>

namespace dewpoint {

void CumulativeWeights::build(const Eigen::ArrayXd& weights, ThreadTeam& team) {
  weights_ = weights.data();
  count_ = weights.size();
  const std::int64_t blocks = (count_ + kPrefixBlock - 1) / kPrefixBlock;
  before_.resize(static_cast<std::size_t>(blocks * kAbreast) + 1);
  before_[0] = 0.0;
  team.forEachBlock(count_, kPrefixBlock, [&](std::int64_t begin, std::int64_t end) {
    const StretchSums sums =
        prefixSums(weights_ + begin, end - begin, [](std::int64_t /*index*/, double /*sum*/) {});
    std::copy(sums.begin(), sums.end(), before_.data() + begin / kStretch + 1);
  });
  for (std::size_t i = 1; i < before_.size(); ++i) {
    before_[i] += before_[i - 1];
  }
}

std::int64_t CumulativeWeights::blockOf(double draw) const {
  const auto end = std::upper_bound(before_.begin() + 1, before_.end(), draw);
  return (end - before_.begin() - 1) / kAbreast;
}

std::int64_t CumulativeWeights::write(std::int64_t block, double* cumulative) const {
  const double* before = before_.data() + block * kAbreast;
  const std::int64_t begin = block * kPrefixBlock;
  const std::int64_t length = std::min(kPrefixBlock, count_ - begin);
  prefixSums(weights_ + begin, length, [&](std::int64_t index, double sum) {
    cumulative[index] = before[index / kStretch] + sum;
  });
  return length;
}

} // namespace dewpoint
