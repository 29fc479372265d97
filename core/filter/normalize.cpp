// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/elementary.h"
#include "core/base/vector_kernel.h"
#include "core/filter/block_sums.h"
#include "core/filter/estimate.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace dewpoint {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The largest finite log weight; minus infinity if there is none.
struct LargestKernel {
  DEWPOINT_KERNEL void run(const double* logWeights, std::int64_t count, double* largest) {
    *largest = strandMax(
        count, -kInfinity, [&](std::int64_t i) __attribute__((always_inline)) {
          return logWeights[i] < kInfinity ? logWeights[i] : -kInfinity; // NaN too
        });
  }
};

/// exp(log weight - largest), zero where that is not finite, and their sum.
struct ExponentialKernel {
  DEWPOINT_KERNEL void run(const double* __restrict logWeights, std::int64_t count, double largest,
                           double* __restrict weights, double* sum) {
    for (std::int64_t i = 0; i < count; ++i) {
      const double difference = logWeights[i] - largest;
      weights[i] = exponential(difference <= 0.0 ? difference : -kInfinity);
    }
    *sum = strandSum(
        count, [&](std::int64_t i) __attribute__((always_inline)) { return weights[i]; });
  }
};

} // namespace

bool normalize(const Eigen::ArrayXd& logWeights, Eigen::ArrayXd& weights, ThreadTeam& team) {
  const Eigen::Index count = logWeights.size();
  weights.resize(count);
  std::vector<double> ofBlock(static_cast<std::size_t>((count + kSumBlock - 1) / kSumBlock));
  const auto forEachBlock = [&](const auto& body) {
    team.forEachBlock(count, kSumBlock, [&](std::int64_t begin, std::int64_t end) {
      body(begin, end - begin, ofBlock.data() + begin / kSumBlock);
    });
  };
  forEachBlock([&](std::int64_t begin, std::int64_t length, double* largest) {
    runKernel<LargestKernel>(logWeights.data() + begin, length, largest);
  });
  const double largest =
      ofBlock.empty() ? -kInfinity : *std::max_element(ofBlock.begin(), ofBlock.end());
  if (largest == -kInfinity) {
    weights.setConstant(count > 0 ? 1.0 / static_cast<double>(count) : 0.0);
    return false;
  }
  forEachBlock([&](std::int64_t begin, std::int64_t length, double* sum) {
    runKernel<ExponentialKernel>(logWeights.data() + begin, length, largest, weights.data() + begin,
                                 sum);
  });
  double total = 0.0;
  for (const double sum : ofBlock) {
    total += sum;
  }
  team.forEachBlock(count, kSumBlock, [&](std::int64_t begin, std::int64_t end) {
    weights.segment(begin, end - begin) /= total;
  });
  return true;
}

} // namespace dewpoint
