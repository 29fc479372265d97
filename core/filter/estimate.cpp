// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/estimate.h"

#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

namespace dewpoint {

bool normalize(const Eigen::ArrayXd& logWeights, Eigen::ArrayXd& weights, ThreadTeam& team) {
  const Eigen::Index count = logWeights.size();
  weights.resize(count);
  double largest = -std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < count; ++i) {
    if (std::isfinite(logWeights[i]) && logWeights[i] > largest) {
      largest = logWeights[i];
    }
  }
  if (!std::isfinite(largest)) {
    weights.setConstant(count > 0 ? 1.0 / static_cast<double>(count) : 0.0);
    return false;
  }
  // std::exp one by one: a vector version would round differently at the seams between threads.
  team.forEachRange(count, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i) {
      weights[i] = std::isfinite(logWeights[i]) ? std::exp(logWeights[i] - largest) : 0.0;
    }
  });
  double total = 0.0;
  for (Eigen::Index i = 0; i < count; ++i) {
    total += weights[i];
  }
  weights /= total;
  return true;
}

StateEstimate estimate(const Eigen::ArrayXXd& states, const Eigen::ArrayXd& weights) {
  assert(states.rows() > 0 && states.rows() == weights.size());
  const Eigen::Index dimension = states.cols();
  StateEstimate result;
  result.mean = Eigen::VectorXd::Zero(dimension);
  result.covariance = Eigen::MatrixXd::Zero(dimension, dimension);
  double squares = 0.0;
  for (Eigen::Index i = 0; i < states.rows(); ++i) {
    for (Eigen::Index a = 0; a < dimension; ++a) {
      result.mean[a] += weights[i] * states(i, a);
    }
    squares += weights[i] * weights[i];
    if (weights[i] > weights[result.bestIndex]) {
      result.bestIndex = i;
    }
  }
  for (Eigen::Index i = 0; i < states.rows(); ++i) {
    for (Eigen::Index a = 0; a < dimension; ++a) {
      const double weighted = weights[i] * (states(i, a) - result.mean[a]);
      for (Eigen::Index b = 0; b <= a; ++b) {
        result.covariance(a, b) += weighted * (states(i, b) - result.mean[b]);
      }
    }
  }
  for (Eigen::Index a = 0; a < dimension; ++a) {
    for (Eigen::Index b = 0; b < a; ++b) {
      result.covariance(b, a) = result.covariance(a, b);
    }
  }
  result.effectiveSampleSize = 1.0 / squares;
  return result;
}

} // namespace dewpoint
