// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/log_weights.h"

#include "core/base/elementary.h"
#include "core/base/vector_kernel.h"
#include "core/filter/block_sums.h"

#include <limits>

namespace dewpoint::filter {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct LargestKernel {
  DEWPOINT_KERNEL void run(const double* logWeights, std::int64_t count, double* largest) {
    *largest = maxInLanes(
        count, -kInfinity, [&](std::int64_t i) __attribute__((always_inline)) {
          return logWeights[i] < kInfinity ? logWeights[i] : -kInfinity; // NaN too
        });
  }
};

struct ExponentialKernel {
  DEWPOINT_KERNEL void run(const double* __restrict logWeights, std::int64_t count, double largest,
                           double* __restrict weights, double* sum) {
    for (std::int64_t i = 0; i < count; ++i) {
      const double difference = logWeights[i] - largest;
      weights[i] = exponential(difference <= 0.0 ? difference : -kInfinity);
    }
    *sum = sumInLanes(
        count, [&](std::int64_t i) __attribute__((always_inline)) { return weights[i]; });
  }
};

} // namespace

double largestLogWeight(const double* logWeights, std::int64_t count) {
  double largest = -kInfinity;
  runKernel<LargestKernel>(logWeights, count, &largest);
  return largest;
}

double relativeWeights(const double* logWeights, std::int64_t count, double largest,
                       double* weights) {
  double sum = 0.0;
  runKernel<ExponentialKernel>(logWeights, count, largest, weights, &sum);
  return sum;
}

} // namespace dewpoint::filter
