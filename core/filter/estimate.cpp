// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/estimate.h"

#include "core/filter/block_sums.h"

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

namespace dewpoint::filter {

StateEstimate estimateFrom(Moments moments) {
  StateEstimate result;
  result.mean = std::move(moments.mean);
  result.covariance = moments.scatter.selfadjointView<Eigen::Lower>();
  result.bestIndex = moments.largestIndex;
  result.effectiveSampleSize = 1.0 / moments.squares;
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

} // namespace dewpoint::filter
