// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/estimate.h"

#include "core/filter/block_sums.h"
#include "core/filter/log_weights.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>
#include <vector>

namespace dewpoint::filter {

StateEstimate estimateFrom(Moments moments) {
  StateEstimate result;
  result.mean = std::move(moments.mean);
  result.covariance = moments.scatter.selfadjointView<Eigen::Lower>();
  result.bestIndex = moments.largestIndex;
  result.effectiveSampleSize = 1.0 / moments.squaredWeightSum;
  return result;
}

StateEstimate estimate(const Eigen::ArrayXXd& states, const Eigen::ArrayXd& weights,
                       ThreadTeam& team) {
  assert(states.rows() > 0 && states.rows() == weights.size());
  std::vector<Moments> ofBlock(std::size_t((states.rows() + kSumBlock - 1) / kSumBlock));
  team.forEachBlock(states.rows(), kSumBlock, [&](std::int64_t begin, std::int64_t end) {
    ofBlock[std::size_t(begin / kSumBlock)] =
        measureMoments(states, weights.data() + begin, begin, end);
  });
  Moments all;
  for (const Moments& block : ofBlock) {
    all.add(block);
  }
  return estimateFrom(std::move(all));
}

StateEstimate estimate(const Eigen::ArrayXXd& states, const Eigen::ArrayXd& weights) {
  ThreadTeam alone(1);
  return estimate(states, weights, alone);
}

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
    *largest = largestLogWeight(logWeights.data() + begin, length);
  });
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double largest =
      ofBlock.empty() ? -kInfinity : *std::max_element(ofBlock.begin(), ofBlock.end());
  if (largest == -kInfinity) {
    weights.setConstant(count > 0 ? 1.0 / static_cast<double>(count) : 0.0);
    return false;
  }
  forEachBlock([&](std::int64_t begin, std::int64_t length, double* sum) {
    *sum = relativeWeights(logWeights.data() + begin, length, largest, weights.data() + begin);
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

} // namespace dewpoint::filter
