// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_motion/agreement/agreement_model.h"

#include "core/base/angle.h"
#include "core/base/statistics.h"
#include "core/geometry/linear_algebra.h"
#include "core/geometry/rotation_vector.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace dewpoint::camera_motion {
namespace {

// What a calibration and a clock may have wrong without being wrong. Calibrations by hand are good
// to 0.2 degrees, 2 mm and half a per cent of the focal length (grade `room` of the suite):
// together about 0.23 degrees per axis as seen from a desk's cameras.
constexpr double kTurnSigma = 0.2 * kDegree; ///< per axis
constexpr double kDelaySigma = 0.3;          ///< intervals between images: free-running cameras
/// Of what is wrong: a rotation of 9 degrees is three standard deviations.
constexpr double kFreeTurnSigma = 3.0 * kDegree;
constexpr double kFreeDelaySigma = 0.25; ///< seconds; half a second is two standard deviations

// Chosen on tuning seeds.
/// That a sighting has no counterpart among another camera's regions: hidden, or not the target.
constexpr double kUnmatched = 0.3;
/// Intervals by whose motion a region is uncertain: rolling shutters and time stamps.
constexpr double kMotionSigma = 0.2;
constexpr double kNearestInstant = 0.8;  ///< intervals between an instant and the image for it
constexpr std::size_t kMostCounted = 40; ///< sightings per camera and color
/// Radii by which the middle of a body of any shape is off that of its outline, as seen from
/// elsewhere.
constexpr double kAnyShape = 0.3;
constexpr double kFewestOfCamera = 2.0; ///< comparisons by which a camera is judged
constexpr std::size_t kFewestSizes = 6;

constexpr int kUnknowns = 4; ///< of a camera: turn, delay

} // namespace

/// Normal equations.
struct AgreementModel::Sums {
  using Slope = Eigen::Matrix<double, 2 * kUnknowns, 1>; ///< by the unknowns of two cameras
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;

  void add(std::size_t a, std::size_t b, const Slope& slope, double share, double residual);
};

AgreementModel::AgreementModel(const CameraRig& rig,
                               const std::vector<std::vector<SightingHistory>>& histories,
                               std::vector<double> radii)
    : histories_(histories), radii_(std::move(radii)) {
  for (const Camera& camera : rig) {
    const Intrinsics& in = camera.intrinsics;
    unprojectors_.emplace_back(geometry::withoutPose(camera));
    focals_.push_back(std::sqrt(in.focalX * in.focalY));
    cameras_.push_back(
        {camera.center(), camera.cameraFromWorld.linear().transpose(), in.height / focals_.back()});
  }
  std::vector<double> gaps;
  for (const auto& color : histories_) {
    for (const SightingHistory& history : color) {
      for (std::size_t i = 1; i < history.images().size(); ++i) {
        gaps.push_back(history.images()[i].captureTime - history.images()[i - 1].captureTime);
      }
    }
  }
  imageInterval_ = base::upperMedian(std::move(gaps));
  for (std::size_t color = 0; color < histories_.size(); ++color) {
    auto& views = views_.emplace_back();
    for (std::size_t k = 0; k < cameras_.size(); ++k) {
      views.push_back(regionImagesOf(color, k, k));
    }
  }
}

std::vector<AgreementModel::RegionImage>
AgreementModel::regionImagesOf(std::size_t color, std::size_t camera,
                               std::size_t calibration) const {
  constexpr double kStep = 0.01; // seconds, of the derivative
  const SightingHistory& history = histories_[color][camera];
  const double focal = focals_[calibration];
  const double anyShape = radii_[color] > 0.0 ? 0.0 : kAnyShape;
  const std::size_t stride = history.countEvidence() / kMostCounted + 1;
  std::size_t counted = 0;
  std::vector<RegionImage> instants;
  instants.reserve(history.images().size());
  for (const SightingImage& image : history.images()) {
    RegionImage& instant = instants.emplace_back(RegionImage{image.captureTime, {}});
    instant.regions.reserve(image.regions.size());
    for (const RegionSighting& sighting : image.regions) {
      const auto& [center, radius, sigma, byShape] = sighting.region;
      const double bias = std::hypot(byShape, anyShape * radius);
      const bool counts = sighting.countsAsEvidence && counted++ % stride == 0;
      const double uncertain = std::hypot(sigma, anyShape * radius,
                                          kMotionSigma * imageInterval_ * sighting.rate.norm());
      SeenRegion seen{sighting.direction, sighting.directionRate, radius / focal,
                      uncertain / focal,  bias / focal,           counts};
      if (calibration != camera) {
        const auto direction = unprojectors_[calibration].worldDirection(center);
        const auto next = unprojectors_[calibration].worldDirection(center + kStep * sighting.rate);
        if (!direction || !next) {
          continue;
        }
        seen.direction = *direction;
        seen.directionRate = (*next - *direction) / kStep;
      }
      instant.regions.push_back(seen);
    }
  }
  return instants;
}

double AgreementModel::biasOf(const Views& views, std::size_t camera) {
  std::vector<double> biases;
  for (const auto& color : views) {
    for (const RegionImage& instant : color[camera]) {
      for (const SeenRegion& seen : instant.regions) {
        if (seen.countsAsEvidence) {
          biases.push_back(seen.biasSigma);
        }
      }
    }
  }
  return base::upperMedian(std::move(biases));
}

const AgreementModel::RegionImage* AgreementModel::nearest(const std::vector<RegionImage>& instants,
                                                           double time, double within) {
  const auto after = std::ranges::lower_bound(instants, time, {}, &RegionImage::time);
  const RegionImage* best = after != instants.end() ? &*after : nullptr;
  if (after != instants.begin()) {
    const RegionImage& before = *std::prev(after);
    if (best == nullptr || time - before.time < best->time - time) {
      best = &before;
    }
  }
  return best != nullptr && std::abs(best->time - time) <= within ? best : nullptr;
}

template <class Visit>
void AgreementModel::compare(const Views& views, const std::vector<Pose>& poses,
                             const std::vector<CameraError>& errors, double widening,
                             std::optional<std::size_t> only, const Visit& visit) const {
  const std::size_t count = poses.size();
  std::vector<Eigen::Matrix3d> rotations;
  for (std::size_t k = 0; k < count; ++k) {
    rotations.push_back(poses[k].worldFromCamera * geometry::rotationFromVector(-errors[k].turn));
  }
  std::vector<RegionMatch> matches;
  for (std::size_t color = 0; color < views.size(); ++color) {
    for (std::size_t a = 0; a < count; ++a) {
      for (const RegionImage& instant : views[color][a]) {
        for (const SeenRegion& seen : instant.regions) {
          if (!seen.countsAsEvidence) {
            continue;
          }
          const Eigen::Vector3d u = rotations[a] * seen.direction;
          for (std::size_t b = 0; b < count; ++b) {
            const Eigen::Vector3d apart = poses[b].center - poses[a].center;
            if (b == a || (only && *only != a && *only != b) || apart.isZero(0.0)) {
              continue;
            }
            const double time = instant.time - errors[a].delay + errors[b].delay;
            const RegionImage* other =
                nearest(views[color][b], time, kNearestInstant * imageInterval_);
            if (other == nullptr || other->regions.empty()) {
              continue;
            }
            matches.clear();
            double sum = 0.0;
            for (const SeenRegion& there : other->regions) {
              const Eigen::Vector3d v =
                  rotations[b] *
                  (there.direction + (time - other->time) * there.directionRate).normalized();
              matches.push_back(
                  matchRegions(seen, u, there, v, apart, widening, poses[b].verticalFieldOfView));
              sum += matches.back().relativeLikelihood;
            }
            const double share = (1.0 - kUnmatched) / static_cast<double>(matches.size());
            const double likelihood = kUnmatched + share * sum;
            for (RegionMatch& match : matches) {
              match.relativeLikelihood *=
                  share / likelihood; // now the probability of this assignment
            }
            visit(a, b, color, seen, *other, rotations, matches, likelihood);
          }
        }
      }
    }
  }
}

std::vector<std::pair<std::size_t, std::size_t>> AgreementModel::pairs() const {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t a = 0; a < cameras_.size(); ++a) {
    for (std::size_t b = a + 1; b < cameras_.size(); ++b) {
      pairs.emplace_back(a, b);
    }
  }
  return pairs;
}

Eigen::VectorXd AgreementModel::priorInformation(const AgreementHypothesis& hypothesis,
                                                 const Views& views) const {
  Eigen::VectorXd priors(static_cast<Eigen::Index>(kUnknowns * cameras_.size()));
  for (std::size_t k = 0; k < cameras_.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(kUnknowns * k);
    const double turn = std::hypot(
        hypothesis.cameraWithFreeRotation == k ? kFreeTurnSigma : kTurnSigma, biasOf(views, k));
    const double delay =
        hypothesis.cameraWithFreeDelay == k ? kFreeDelaySigma : kDelaySigma * imageInterval_;
    priors.segment<3>(at).setConstant(1.0 / (turn * turn));
    priors[at + 3] = 1.0 / (delay * delay);
  }
  return priors;
}

void AgreementModel::Sums::add(std::size_t a, std::size_t b, const Slope& slope, double share,
                               double residual) {
  const auto atA = static_cast<Eigen::Index>(kUnknowns * a);
  const auto atB = static_cast<Eigen::Index>(kUnknowns * b);
  const Eigen::Matrix<double, 8, 8> square = share * slope * slope.transpose();
  information.block<4, 4>(atA, atA) += square.topLeftCorner<4, 4>();
  information.block<4, 4>(atA, atB) += square.topRightCorner<4, 4>();
  information.block<4, 4>(atB, atA) += square.bottomLeftCorner<4, 4>();
  information.block<4, 4>(atB, atB) += square.bottomRightCorner<4, 4>();
  gradient.segment<4>(atA) -= share * residual * slope.head<4>();
  gradient.segment<4>(atB) -= share * residual * slope.tail<4>();
}

AgreementFit AgreementModel::evaluate(const Views& views, const std::vector<Pose>& poses,
                                      const Eigen::VectorXd& unknowns, double widening,
                                      Sums& sums) const {
  const std::size_t count = cameras_.size();
  // Of what pairs of cameras say, so much is new: an object's position takes three numbers.
  const double pairCount = 0.5 * static_cast<double>(count * (count - 1));
  const double weight = 0.5 * std::min(1.0, static_cast<double>(2 * count - 3) / pairCount);
  AgreementFit fit;
  fit.pairLogLikelihoods.assign(count * count, 0.0);
  fit.pairComparisonCounts.assign(count * count, 0.0);
  for (std::size_t k = 0; k < count; ++k) {
    const auto at = static_cast<Eigen::Index>(kUnknowns * k);
    fit.errors.push_back({unknowns.segment<3>(at), unknowns[at + 3]});
  }
  compare(views, poses, fit.errors, widening, std::nullopt,
          [&](std::size_t a, std::size_t b, std::size_t, const SeenRegion& seen,
              const RegionImage& other, const std::vector<Eigen::Matrix3d>& rotations,
              const std::vector<RegionMatch>& matches, double likelihood) {
            const std::size_t pair = std::min(a, b) * count + std::max(a, b);
            fit.pairLogLikelihoods[pair] += weight * std::log(likelihood);
            fit.pairComparisonCounts[pair] += weight;
            for (std::size_t i = 0; i < matches.size(); ++i) {
              constexpr double kNegligible = 1e-6; // of one sighting
              const double share = weight * matches[i].relativeLikelihood;
              if (share < kNegligible) {
                continue;
              }
              const SeenRegion& there = other.regions[i];
              const Eigen::Vector3d residualByU = rotations[a].transpose() * matches[i].residualByU;
              const Eigen::Vector3d residualByV = rotations[b].transpose() * matches[i].residualByV;
              Sums::Slope slope;
              slope.segment<3>(0) = residualByU.cross(seen.direction);
              slope[3] = -residualByV.dot(there.directionRate);
              slope.segment<3>(4) = residualByV.cross(there.direction);
              slope[7] = residualByV.dot(there.directionRate);
              sums.add(a, b, slope, share, matches[i].residual);
            }
          });
  for (std::size_t pair = 0; pair < fit.pairComparisonCounts.size(); ++pair) {
    fit.logLikelihood += fit.pairLogLikelihoods[pair];
    fit.comparisonCount += fit.pairComparisonCounts[pair];
  }
  return fit;
}

void AgreementModel::summarizePairs(AgreementFit& fit) const {
  const std::size_t count = cameras_.size();
  std::vector<double> likelihoods, counts, ofCamera(count, 0.0), countOfCamera(count, 0.0);
  for (const auto& [a, b] : pairs()) {
    likelihoods.push_back(fit.pairLogLikelihoods[a * count + b]);
    counts.push_back(fit.pairComparisonCounts[a * count + b]);
    for (const std::size_t camera : {a, b}) {
      ofCamera[camera] += likelihoods.back();
      countOfCamera[camera] += counts.back();
    }
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t camera = 0; camera < count; ++camera) {
    if (countOfCamera[camera] >= kFewestOfCamera) {
      least = std::min(least, ofCamera[camera] / countOfCamera[camera]);
    }
  }
  fit.lowestMeanLogLikelihood = std::isfinite(least) ? least : 0.0;
  fit.pairLogLikelihoods = std::move(likelihoods);
  fit.pairComparisonCounts = std::move(counts);
}

AgreementModel::Views
AgreementModel::viewsWith(const std::vector<std::size_t>& calibrations) const {
  Views views = views_;
  for (std::size_t color = 0; color < views.size(); ++color) {
    for (std::size_t k = 0; k < calibrations.size(); ++k) {
      if (calibrations[k] != k) {
        views[color][k] = regionImagesOf(color, k, calibrations[k]);
      }
    }
  }
  return views;
}

AgreementFit AgreementModel::fit(const AgreementHypothesis& hypothesis) const {
  std::vector<Pose> poses = cameras_;
  for (std::size_t k = 0; k < hypothesis.calibrationIndices.size(); ++k) {
    poses[k] = cameras_[hypothesis.calibrationIndices[k]];
  }
  const bool isDeclared = hypothesis.calibrationIndices.empty();
  const Views borrowed = isDeclared ? Views() : viewsWith(hypothesis.calibrationIndices);
  const Views& views = isDeclared ? views_ : borrowed;
  const Eigen::VectorXd priors = priorInformation(hypothesis, views); // inverse variances
  // From coarse to fine: what is far off finds its counterpart first.
  static constexpr std::array kFromFar{0.09, 0.03, 0.01, 0.003, 0.0, 0.0, 0.0};
  static constexpr std::array kFromNear{0.01, 0.003, 0.0, 0.0, 0.0};
  const std::span<const double> widenings = hypothesis.cameraWithFreeRotation
                                                ? std::span<const double>(kFromFar)
                                                : std::span<const double>(kFromNear);
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(priors.size());
  if (hypothesis.cameraWithFreeDelay) {
    unknowns[static_cast<Eigen::Index>(kUnknowns * *hypothesis.cameraWithFreeDelay) + 3] =
        hypothesis.initialDelay;
  }
  std::optional<AgreementFit> best;
  for (const double widening : widenings) {
    Sums sums{priors.asDiagonal(), -(priors.array() * unknowns.array()).matrix()};
    AgreementFit now = evaluate(views, poses, unknowns, widening, sums);
    now.logPrior = -0.5 * (priors.array() * unknowns.array().square()).sum();
    if (widening == 0.0 &&
        (!best || now.logLikelihood + now.logPrior > best->logLikelihood + best->logPrior)) {
      constexpr double kLeastInformation = 1e-12; // nothing but rounding
      const Eigen::VectorXd values = geometry::symmetricEigen(sums.information).eigenvalues;
      const double volume =
          0.5 * (priors.array().log().sum() - values.array().max(kLeastInformation).log().sum());
      now.logEvidence = now.logLikelihood + now.logPrior + volume;
      best = std::move(now);
    }
    unknowns += geometry::solveSymmetric(sums.information, sums.gradient);
  }
  summarizePairs(*best);
  return std::move(*best);
}

double AgreementModel::approximateLogLikelihood(std::size_t camera, double delay) const {
  std::vector<CameraError> errors(cameras_.size());
  errors[camera].delay = delay;
  double sum = 0.0;
  compare(views_, cameras_, errors, kTurnSigma, camera,
          [&](std::size_t, std::size_t, std::size_t, const SeenRegion&, const RegionImage&,
              const std::vector<Eigen::Matrix3d>&, const std::vector<RegionMatch>&,
              double likelihood) { sum += std::log(likelihood); });
  return sum;
}

std::optional<double> AgreementModel::sizeRatio(const std::vector<CameraError>& errors) const {
  std::vector<double> ratios;
  compare(
      views_, cameras_, errors, 0.0, std::nullopt,
      [&](std::size_t, std::size_t, std::size_t color, const SeenRegion&, const RegionImage&,
          const std::vector<Eigen::Matrix3d>&, const std::vector<RegionMatch>& matches, double) {
        for (const RegionMatch& match : matches) {
          if (match.relativeLikelihood > 0.5 && match.objectRadius > 0.0 && radii_[color] > 0.0) {
            ratios.push_back(match.objectRadius / radii_[color]);
          }
        }
      });
  return ratios.size() < kFewestSizes ? std::nullopt
                                      : std::optional(base::upperMedian(std::move(ratios)));
}

} // namespace dewpoint::camera_motion
