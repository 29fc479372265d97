// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/hypothesis_estimate.h"

#include "core/filter/estimate.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

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

/// Probability that a normal vector of mean zero is shorter than `radius`: its squared length is
/// approximated by a scaled chi-square variable of the same mean and variance (Satterthwaite 1946),
/// whose cube root is nearly normal (Wilson and Hilferty 1931).
double probabilityWithin(const Eigen::Matrix3d& covariance, double radius) {
  const double trace = covariance.trace();
  const double freedoms = trace * trace / covariance.squaredNorm();
  const double variance = 2.0 / (9.0 * freedoms);
  const double off = (std::cbrt(radius * radius / trace) - (1.0 - variance)) / std::sqrt(variance);
  return 0.5 * std::erfc(-off / std::numbers::sqrt2);
}

/// Probability that the target is still near the position of a hypothesis, if it exists at all; 1
/// while it is seen.
double probabilityNearby(const TrackHypothesis& hypothesis) {
  return hypothesis.processNoise.unseenSteps() == 0
             ? 1.0
             : probabilityWithin(hypothesis.gaussian.covariance.topLeftCorner<3, 3>(),
                                 std::max(kNearby, hypothesis.radius));
}

/// Relative standard deviation of the distance that the size of an outline says. A judgment: blur
/// and shade move an edge by a tenth of the radius (docs/method-dewpoint.md, section 6).
constexpr double kSizeSigma = 0.1;

/// Covariance (m²) of a position from directions that are off by `sigma` (radians) in the cameras
/// that see it.
Eigen::Matrix3d covarianceOfDirections(const Eigen::Vector3d& position,
                                       const std::vector<CameraEvidence>& cameras, double sigma,
                                       const SphereObservation& observation) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    if (!cameras[k].inView || cameras[k].visible < kSeenShare) {
      continue;
    }
    const Eigen::Vector3d ray = position - observation.projector(k).cameraCenter();
    const double distance = ray.norm();
    const Eigen::Vector3d along = ray / distance;
    const Eigen::Matrix3d depth = along * along.transpose();
    information += (Eigen::Matrix3d::Identity() - depth) / std::pow(distance * sigma, 2) +
                   depth / std::pow(distance * kSizeSigma, 2);
  }
  return information.isZero(0.0) ? Eigen::Matrix3d(Eigen::Matrix3d::Zero())
                                 : Eigen::Matrix3d(information.inverse());
}

/// The covariance (m²) of a position whose covariance by images and by what was `given` is `known`,
/// when `systematic` errors of the images add to it. They do not touch what was given by hand.
Eigen::Matrix3d withSystematicErrors(const Eigen::Matrix3d& known,
                                     const Eigen::Matrix3d& systematic,
                                     const std::optional<Eigen::Matrix3d>& given) {
  if (!given || systematic.isZero(0.0)) {
    return known + systematic;
  }
  const Eigen::Matrix3d byHand = given->inverse();
  // What the images alone say; none in a direction in which they say nothing.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> images(known.inverse() - byHand);
  const Eigen::Matrix3d root = images.eigenvectors() *
                               images.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
                               images.eigenvectors().transpose();
  const Eigen::Matrix3d wider = Eigen::Matrix3d::Identity() + root * systematic * root;
  return (byHand + root * wider.inverse() * root).inverse();
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
  result.degenerate = moments.degenerate;
  return result;
}

} // namespace

SphereEstimate sphereEstimateFrom(const TrackHypothesis& hypothesis, double identityAmbiguity,
                                  const SystematicErrors& errors, SphereObservation& observation) {
  SphereEstimate result = momentsOf(hypothesis.states, hypothesis.weights);
  result.covariance = hypothesis.gaussian.covariance.topLeftCorner<3, 3>();
  if (hypothesis.outlineFound) {
    result.measurement = hypothesis.measurement;
  }
  const double near = probabilityNearby(hypothesis);
  result.existenceProbability =
      std::min(1.0, hypothesis.probability) * (1.0 - identityAmbiguity) * near;
  result.radius = hypothesis.radius;
  observation.setRadius(hypothesis.radius);
  result.cameras = observation.evidence(result.mean, hypothesis.velocity());
  result.camerasSeeing = SphereObservation::camerasSeeing(result.cameras);
  const Eigen::Vector3d shift = errors.time * hypothesis.velocity();
  Eigen::Matrix3d systematic = shift * shift.transpose();
  if (errors.direction > 0.0) {
    systematic +=
        covarianceOfDirections(result.mean, result.cameras, errors.direction, observation);
  }
  result.covariance = withSystematicErrors(result.covariance, systematic, hypothesis.given);
  result.valid = hypothesis.probability * near > 0.5 && isUseful(hypothesis);
  return result;
}

SphereEstimate sphereEstimateFrom(const SearchParticles& particles) {
  return momentsOf(particles.states(), particles.weights());
}

} // namespace dewpoint::tracking
