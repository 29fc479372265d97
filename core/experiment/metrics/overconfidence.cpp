// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/overconfidence.h"

#include "core/tracking/track_estimate.h"

namespace dewpoint::experiment {

double statedRadius(const Eigen::Matrix3d& covariance) {
  return spreadOf(covariance);
}

bool isWrong(const StatedBelief& belief, double gate) {
  // The comparison is false for NaN, so that such a position is wrong.
  return belief.declared && !(belief.truth && (belief.position - *belief.truth).norm() < gate);
}

bool isSureAndWrong(const StatedBelief& belief) {
  if (!(belief.probability > kSureProbability)) {
    return false;
  }
  return !(belief.truth && (belief.position - *belief.truth).norm() <=
                               kSureRadii * statedRadius(belief.covariance));
}

Overconfidence overconfidence(std::span<const StatedBelief> beliefs, double gate) {
  Overconfidence result;
  for (Proportion* share : {&result.wrong, &result.wrongWhenSure, &result.sureAndWrong}) {
    share->total = static_cast<std::int64_t>(beliefs.size());
  }
  for (const StatedBelief& belief : beliefs) {
    const bool wrong = isWrong(belief, gate);
    result.wrong.count += wrong ? 1 : 0;
    result.wrongWhenSure.count += wrong && belief.probability > kSureProbability ? 1 : 0;
    result.sureAndWrong.count += isSureAndWrong(belief) ? 1 : 0;
  }
  return result;
}

} // namespace dewpoint::experiment
