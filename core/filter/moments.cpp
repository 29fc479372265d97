// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/moments.h"

#include "core/base/vector_kernel.h"
#include "core/filter/block_sums.h"

#include <algorithm>

namespace dewpoint::filter {
namespace {

struct WeightKernel {
  DEWPOINT_KERNEL void run(const double* weights, std::int64_t count, Moments* moments) {
    moments->weightSum = sumInLanes(
        count, [&](std::int64_t i) __attribute__((always_inline)) { return weights[i]; });
    moments->squaredWeightSum = sumInLanes(
        count, [&](std::int64_t i)
                   __attribute__((always_inline)) { return weights[i] * weights[i]; });
    moments->largestWeight = maxInLanes(
        count, -1.0, [&](std::int64_t i) __attribute__((always_inline)) { return weights[i]; });
  }
};

struct MeanKernel {
  DEWPOINT_KERNEL void run(const double* weights, const double* x, std::int64_t count,
                           double* sum) {
    *sum = sumInLanes(
        count, [&](std::int64_t i) __attribute__((always_inline)) { return weights[i] * x[i]; });
  }
};

struct ScatterKernel {
  DEWPOINT_KERNEL void run(const double* weights, const double* x, double meanX, const double* y,
                           double meanY, std::int64_t count, double* sum) {
    *sum = sumInLanes(
        count, [&](std::int64_t i) __attribute__((always_inline)) {
          return weights[i] * (x[i] - meanX) * (y[i] - meanY);
        });
  }
};

} // namespace

void Moments::add(const Moments& other, double factor) {
  squaredWeightSum += other.squaredWeightSum * factor * factor;
  if (other.largestWeight * factor > largestWeight) {
    largestWeight = other.largestWeight * factor;
    largestIndex = other.largestIndex;
  }
  const double added = other.weightSum * factor;
  if (!(added > 0.0)) {
    return;
  }
  if (mean.size() == 0) {
    mean.setZero(other.mean.size());
    scatter.setZero(other.mean.size(), other.mean.size());
  }
  const double sum = weightSum + added;
  const Eigen::VectorXd step = other.mean - mean;
  const double lever = weightSum * (added / sum);
  for (Eigen::Index a = 0; a < step.size(); ++a) {
    for (Eigen::Index b = 0; b <= a; ++b) {
      scatter(a, b) += other.scatter(a, b) * factor + lever * step[a] * step[b];
    }
    mean[a] += step[a] * (added / sum);
  }
  weightSum = sum;
}

Moments measureMoments(const Eigen::ArrayXXd& states, const double* weights, std::int64_t begin,
                       std::int64_t end) {
  Moments moments;
  const std::int64_t count = end - begin;
  const auto column = [&](Eigen::Index a) { return states.col(a).data() + begin; };
  runKernel<WeightKernel>(weights, count, &moments);
  moments.largestIndex =
      begin + (std::find(weights, weights + count, moments.largestWeight) - weights);
  if (!(moments.weightSum > 0.0)) {
    return moments;
  }
  const Eigen::Index dimension = states.cols();
  moments.mean.resize(dimension);
  moments.scatter.resize(dimension, dimension);
  for (Eigen::Index a = 0; a < dimension; ++a) {
    runKernel<MeanKernel>(weights, column(a), count, &moments.mean[a]);
    moments.mean[a] /= moments.weightSum;
  }
  for (Eigen::Index a = 0; a < dimension; ++a) {
    for (Eigen::Index b = 0; b <= a; ++b) {
      runKernel<ScatterKernel>(weights, column(a), moments.mean[a], column(b), moments.mean[b],
                               count, &moments.scatter(a, b));
    }
  }
  return moments;
}

} // namespace dewpoint::filter
