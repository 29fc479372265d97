// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/cumulative.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace dewpoint {
namespace {

constexpr std::int64_t kStretch = CumulativeWeights::kStretch;
/// Stretches that are summed up side by side: an addition has to wait for the one before it, but
/// not for those of other stretches.
constexpr std::int64_t kAbreast = 4;

double sumInOrder(const double* weights, std::int64_t count) {
  double sum = 0.0;
  for (std::int64_t i = 0; i < count; ++i) {
    sum += weights[i];
  }
  return sum;
}

std::array<double, kAbreast> sumsAbreast(const double* weights) {
  std::array<double, kAbreast> sum{};
  for (std::int64_t i = 0; i < kStretch; ++i) {
    for (std::int64_t k = 0; k < kAbreast; ++k) {
      sum[std::size_t(k)] += weights[k * kStretch + i];
    }
  }
  return sum;
}

void writeStretch(const double* weights, std::int64_t count, double before, double* cumulative) {
  double sum = 0.0;
  for (std::int64_t i = 0; i < count; ++i) {
    sum += weights[i];
    cumulative[i] = before + sum;
  }
}

void writeAbreast(const double* weights, const double* before, double* cumulative) {
  std::array<double, kAbreast> sum{};
  for (std::int64_t i = 0; i < kStretch; ++i) {
    for (std::int64_t k = 0; k < kAbreast; ++k) {
      sum[std::size_t(k)] += weights[k * kStretch + i];
      cumulative[k * kStretch + i] = before[k] + sum[std::size_t(k)];
    }
  }
}

} // namespace

void CumulativeWeights::build(const Eigen::ArrayXd& weights, ThreadTeam& team) {
  weights_ = weights.data();
  const Eigen::Index count = weights.size();
  before_.assign(static_cast<std::size_t>((count + kStretch - 1) / kStretch) + 1, 0.0);
  team.forEachBlock(count, kAbreast * kStretch, [&](std::int64_t begin, std::int64_t end) {
    double* sums = before_.data() + begin / kStretch + 1;
    if (end - begin == kAbreast * kStretch) {
      const auto four = sumsAbreast(weights_ + begin);
      std::copy(four.begin(), four.end(), sums);
      return;
    }
    for (; begin < end; begin += kStretch) {
      *sums++ = sumInOrder(weights_ + begin, std::min(kStretch, end - begin));
    }
  });
  for (std::size_t i = 1; i < before_.size(); ++i) {
    before_[i] += before_[i - 1];
  }
}

void CumulativeWeights::write(std::int64_t begin, std::int64_t end, double* cumulative) const {
  const double* before = before_.data() + begin / kStretch;
  for (; end - begin >= kAbreast * kStretch; begin += kAbreast * kStretch) {
    writeAbreast(weights_ + begin, before, cumulative);
    before += kAbreast;
    cumulative += kAbreast * kStretch;
  }
  for (; begin < end; begin += kStretch, cumulative += kStretch) {
    writeStretch(weights_ + begin, std::min(kStretch, end - begin), *before++, cumulative);
  }
}

} // namespace dewpoint
