// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/overconfidence.h"

#include "core/tracking/track_estimate.h"

namespace dewpoint::experiment {

double reportedRadius(const Eigen::Matrix3d& covariance) {
  return spreadOf(covariance);
}

bool isWrong(const ReportedBelief& belief, double gate) {
  // The comparison is false for NaN, so that such a position is wrong.
  return belief.isDeclared && !(belief.truth && (belief.position - *belief.truth).norm() < gate);
}

bool isConfidentlyWrong(const ReportedBelief& belief) {
  if (!(belief.probability > kConfidentProbability)) {
    return false;
  }
  return !(belief.truth && (belief.position - *belief.truth).norm() <=
                               kConfidentRadii * reportedRadius(belief.covariance));
}

Overconfidence measureOverconfidence(std::span<const ReportedBelief> beliefs, double gate) {
  Overconfidence result;
  for (Proportion* share :
       {&result.wrongShare, &result.wrongAndConfidentShare, &result.confidentlyWrongShare}) {
    share->total = static_cast<std::int64_t>(beliefs.size());
  }
  for (const ReportedBelief& belief : beliefs) {
    const bool wrong = isWrong(belief, gate);
    result.wrongShare.count += wrong ? 1 : 0;
    result.wrongAndConfidentShare.count +=
        wrong && belief.probability > kConfidentProbability ? 1 : 0;
    result.confidentlyWrongShare.count += isConfidentlyWrong(belief) ? 1 : 0;
  }
  return result;
}

} // namespace dewpoint::experiment
