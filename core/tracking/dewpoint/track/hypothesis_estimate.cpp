// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/hypothesis_estimate.h"

#include "core/filter/estimate.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace dewpoint::tracking {
namespace {

// Reasons: docs/method-dewpoint.md, section 6. They are judgments, not measurements.

/// An estimate with a larger standard deviation is of no use: in radii, and in meters, whichever is
/// more.
constexpr double kUsefulRadii = 3.0;
constexpr double kUsefulSigma = 0.1;
/// Meters. A target that no camera sees counts as there while it is within its radius of the
/// estimate, or within this distance if that is more.
constexpr double kNearby = 0.03;

/// Probability that the target is still near the position of a hypothesis, if it exists at all; 1
/// while it is seen.
double probabilityNearby(const TrackHypothesis& hypothesis) {
  return hypothesis.processNoise.unseenStepCount() == 0
             ? 1.0
             : probabilityWithin(hypothesis.gaussian.covariance.topLeftCorner<3, 3>(),
                                 std::max(kNearby, hypothesis.radius));
}

/// Optical centers of the cameras that see the target.
std::vector<Eigen::Vector3d> seeingCenters(const std::vector<CameraEvidence>& cameras,
                                           const SphereObservation& observation) {
  std::vector<Eigen::Vector3d> centers;
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    if (cameras[k].isInView && cameras[k].visibleShare >= kSeenShare) {
      centers.push_back(observation.projector(k).cameraCenter());
    }
  }
  return centers;
}

bool isUseful(const TrackHypothesis& hypothesis) {
  const double variance = hypothesis.gaussian.covariance.diagonal().head<3>().maxCoeff();
  const double sigma = std::max(kUsefulSigma, kUsefulRadii * hypothesis.radius);
  return variance < sigma * sigma;
}

SphereEstimate momentsOf(const Eigen::ArrayXXd& states, const Eigen::ArrayXd& weights) {
  const StateEstimate moments = estimate(states, weights);
  SphereEstimate result;
  result.mean = moments.mean.head<3>();
  result.best = states.row(moments.bestIndex).head(3).transpose();
  result.covariance = moments.covariance.topLeftCorner<3, 3>();
  result.effectiveSampleSize = moments.effectiveSampleSize;
  result.particleCount = static_cast<int>(states.rows());
  result.isDegenerate = moments.isDegenerate;
  return result;
}

} // namespace

SphereEstimate estimateFrom(const TrackHypothesis& hypothesis, double identityAmbiguity,
                            const std::vector<Eigen::Vector3d>& seeingCenters,
                            const SystematicErrors& errors, const Eigen::Matrix3d& ofShape) {
  SphereEstimate result = momentsOf(hypothesis.states, hypothesis.weights);
  result.covariance = hypothesis.gaussian.covariance.topLeftCorner<3, 3>();
  if (hypothesis.wasOutlineFound) {
    result.measurement = hypothesis.measurement;
  }
  const double near = probabilityNearby(hypothesis);
  result.existenceProbability =
      std::min(1.0, hypothesis.probability) * (1.0 - identityAmbiguity) * near;
  result.radius = hypothesis.radius;
  const Eigen::Vector3d shift = errors.timeSigma * hypothesis.velocity();
  Eigen::Matrix3d systematic = ofShape + shift * shift.transpose();
  if (errors.directionSigma > 0.0) {
    systematic += covarianceFromDirectionErrors(result.mean, seeingCenters, errors.directionSigma);
  }
  result.covariance =
      withSystematicErrors(result.covariance, systematic, hypothesis.givenCovariance);
  result.isValid = hypothesis.probability * near > 0.5 && isUseful(hypothesis);
  return result;
}

SphereEstimate sphereEstimateFrom(const TrackHypothesis& hypothesis, double identityAmbiguity,
                                  const SystematicErrors& errors, SphereObservation& observation) {
  observation.setRadius(hypothesis.radius);
  const Eigen::Vector3d mean = momentsOf(hypothesis.states, hypothesis.weights).mean;
  std::vector<CameraEvidence> cameras = observation.evidence(mean, hypothesis.velocity());
  SphereEstimate result =
      estimateFrom(hypothesis, identityAmbiguity, seeingCenters(cameras, observation), errors,
                   Eigen::Matrix3d::Zero());
  result.seeingCameraCount = SphereObservation::countSeeingCameras(cameras);
  result.cameras = std::move(cameras);
  return result;
}

SphereEstimate sphereEstimateFrom(const SearchParticles& particles) {
  return momentsOf(particles.states(), particles.weights());
}

} // namespace dewpoint::tracking
