// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/estimate.h"

#include "core/base/vector_kernel.h"
#include "core/filter/block_sums.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace dewpoint {
namespace {

/// Weighted moments of some particles. Blocks are put together by the formulas of Chan, Golub and
/// LeVeque (1983), which keep the digits that a sum of squares about a far origin would lose.
struct Moments {
  double weight = 0.0;
  double squares = 0.0; ///< of the weights
  double largest = -1.0;
  Eigen::Index largestIndex = 0;
  Eigen::VectorXd mean;
  Eigen::MatrixXd scatter; ///< sum of weight * deviation * deviation', lower triangle

  void add(const Moments& other) {
    squares += other.squares;
    if (other.largest > largest) {
      largest = other.largest;
      largestIndex = other.largestIndex;
    }
    if (!(other.weight > 0.0)) {
      return;
    }
    const double sum = weight + other.weight;
    const Eigen::VectorXd step = other.mean - mean;
    const double lever = weight * (other.weight / sum);
    for (Eigen::Index a = 0; a < step.size(); ++a) {
      for (Eigen::Index b = 0; b <= a; ++b) {
        scatter(a, b) += other.scatter(a, b) + lever * step[a] * step[b];
      }
      mean[a] += step[a] * (other.weight / sum);
    }
    weight = sum;
  }
};

struct WeightKernel {
  DEWPOINT_KERNEL void run(const double* weights, std::int64_t count, Moments* moments) {
    moments->weight = strandSum(
        count, [&](std::int64_t i) __attribute__((always_inline)) { return weights[i]; });
    moments->squares = strandSum(
        count, [&](std::int64_t i)
                   __attribute__((always_inline)) { return weights[i] * weights[i]; });
    moments->largest = strandMax(
        count, -1.0, [&](std::int64_t i) __attribute__((always_inline)) { return weights[i]; });
  }
};

struct MeanKernel {
  DEWPOINT_KERNEL void run(const double* weights, const double* x, std::int64_t count,
                           double* sum) {
    *sum = strandSum(
        count, [&](std::int64_t i) __attribute__((always_inline)) { return weights[i] * x[i]; });
  }
};

struct ScatterKernel {
  DEWPOINT_KERNEL void run(const double* weights, const double* x, double meanX, const double* y,
                           double meanY, std::int64_t count, double* sum) {
    *sum = strandSum(
        count, [&](std::int64_t i) __attribute__((always_inline)) {
          return weights[i] * (x[i] - meanX) * (y[i] - meanY);
        });
  }
};

/// The moments of particles begin to end - 1.
void measure(const Eigen::ArrayXXd& states, const Eigen::ArrayXd& weights, std::int64_t begin,
             std::int64_t end, Moments& moments) {
  const std::int64_t count = end - begin;
  const double* weight = weights.data() + begin;
  const auto column = [&](Eigen::Index a) { return states.col(a).data() + begin; };
  runKernel<WeightKernel>(weight, count, &moments);
  moments.largestIndex = std::find(weight, weight + count, moments.largest) - weights.data();
  if (!(moments.weight > 0.0)) {
    return;
  }
  const Eigen::Index dimension = states.cols();
  moments.mean.resize(dimension);
  moments.scatter.resize(dimension, dimension);
  for (Eigen::Index a = 0; a < dimension; ++a) {
    runKernel<MeanKernel>(weight, column(a), count, &moments.mean[a]);
    moments.mean[a] /= moments.weight;
  }
  for (Eigen::Index a = 0; a < dimension; ++a) {
    for (Eigen::Index b = 0; b <= a; ++b) {
      runKernel<ScatterKernel>(weight, column(a), moments.mean[a], column(b), moments.mean[b],
                               count, &moments.scatter(a, b));
    }
  }
}

} // namespace

StateEstimate estimate(const Eigen::ArrayXXd& states, const Eigen::ArrayXd& weights,
                       ThreadTeam& team) {
  assert(states.rows() > 0 && states.rows() == weights.size());
  std::vector<Moments> ofBlock(std::size_t((states.rows() + kSumBlock - 1) / kSumBlock));
  team.forEachBlock(states.rows(), kSumBlock, [&](std::int64_t begin, std::int64_t end) {
    measure(states, weights, begin, end, ofBlock[std::size_t(begin / kSumBlock)]);
  });
  const Eigen::Index dimension = states.cols();
  Moments all;
  all.mean = Eigen::VectorXd::Zero(dimension);
  all.scatter = Eigen::MatrixXd::Zero(dimension, dimension);
  for (const Moments& block : ofBlock) {
    all.add(block);
  }
  StateEstimate result;
  result.mean = std::move(all.mean);
  result.covariance = all.scatter.selfadjointView<Eigen::Lower>();
  result.bestIndex = all.largestIndex;
  result.effectiveSampleSize = 1.0 / all.squares;
  return result;
}

StateEstimate estimate(const Eigen::ArrayXXd& states, const Eigen::ArrayXd& weights) {
  ThreadTeam alone(1);
  return estimate(states, weights, alone);
}

} // namespace dewpoint
