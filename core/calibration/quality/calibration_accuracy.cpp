// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/quality/calibration_accuracy.h"

#include "core/base/random.h"
#include "core/base/statistics.h"
#include "core/base/uncertainty_text.h"
#include "core/base/units.h"
#include "core/calibration/quality/block_jackknife.h"
#include "core/calibration/quality/common_view.h"
#include "core/calibration/quality/position_error.h"
#include "core/calibration/wand/wand_gauge.h"
#include "core/geometry/linear_algebra.h"
#include "core/geometry/mean_vector.h"
#include "core/geometry/rotation_vector.h"
#include "core/geometry/similarity.h"
#include "core/geometry/small_matrices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Positions that errors are carried to.
constexpr std::size_t kPositions = 80;
/// Share of the positions of the target that do not count for the box in which it was, at each end
/// of each axis.
constexpr double kOutliers = 0.02;
/// Fewer positions of the lattice outside the box are no region.
constexpr std::size_t kFewestOutside = 12;
constexpr double kOutsideWithin = 0.95; ///< share of them that is nearer than the distance stated
/// Draws that the 95 % are read off.
constexpr std::uint32_t kDraws = 200;
constexpr double kClearlyLarger = 1.5;    ///< ten solutions scatter by chance up to here
constexpr double kNinetyFive = 1.96;      ///< standard deviations, one axis
constexpr double kNinetyFivePlane = 2.45; ///< two axes: sqrt(-2 log 0.05)
/// m/s², of a fall.
constexpr double kGravity = 9.81;    ///< m/s²
constexpr double kTouchSigma = 1e-3; ///< meters: how well a ball is held on the floor

/// Scatter over predicted standard deviation of the positions.
double ratioOf(const Eigen::MatrixXd& empirical, const Eigen::MatrixXd& predicted) {
  return predicted.squaredNorm() > 0.0 ? empirical.norm() / predicted.norm() : 0.0;
}

/// Moves the cameras of each solution with the positions that it triangulates, back onto those of
/// the whole: where the world is arbitrary, only what cameras are to these positions is known.
void alignSolutions(const PositionErrors& errors, const Eigen::MatrixXd& changes, bool sizeToo,
                    std::vector<CameraRig>& solutions) {
  for (std::size_t column = 0; column < solutions.size(); ++column) {
    std::vector<Eigen::Vector3d> found;
    for (std::size_t i = 0; i < errors.positions.size(); ++i) {
      found.emplace_back(
          errors.positions[i] +
          changes.block<3, 1>(static_cast<Eigen::Index>(3 * i), static_cast<Eigen::Index>(column)));
    }
    const Similarity back = fitSimilarity(found, errors.positions, sizeToo);
    for (Camera& camera : solutions[column]) {
      const Eigen::Vector3d center = back * camera.center();
      camera.cameraFromWorld.linear() = camera.cameraFromWorld.linear() * back.rotation.transpose();
      camera.cameraFromWorld.translation() = -camera.cameraFromWorld.linear() * center;
    }
  }
}

/// Covariance of the three numbers that begin with `first`; zero if they are not free.
Eigen::Matrix3d covarianceOf(const BundleCovariance& covariance, std::size_t camera,
                             CameraQuantity first) {
  for (std::size_t k = 0; k < covariance.columns.size(); ++k) {
    if (covariance.columns[k].camera == camera && covariance.columns[k].quantity == first) {
      const auto at = static_cast<Eigen::Index>(k);
      return covariance.matrix.block<3, 3>(at, at);
    }
  }
  return Eigen::Matrix3d::Zero();
}

/// What the covariance says, and what the solutions without a block say: the larger.
CameraAccuracy accuracyOf(std::size_t camera, const BundleResult& result,
                          const std::vector<CameraRig>& solutions, double factor) {
  const double noise = result.residualToSigmaRatio * result.residualToSigmaRatio;
  const Camera& whole = result.cameras[camera];
  Eigen::Matrix3Xd centers(3, static_cast<Eigen::Index>(solutions.size()));
  Eigen::Matrix3Xd turns = centers;
  for (std::size_t k = 0; k < solutions.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    const Camera& other = solutions[k][camera];
    centers.col(at) = other.center() - whole.center();
    turns.col(at) = vectorFromRotation(other.cameraFromWorld.linear() *
                                       whole.cameraFromWorld.linear().transpose());
  }
  const auto bound = [&](CameraQuantity quantity, const Eigen::Matrix3Xd& changes) {
    const Eigen::Matrix3d stated = noise * covarianceOf(result.covariance, camera, quantity);
    if (factor <= 0.0 || stated.isZero()) { // a camera that is held has no error by convention
      return lengthBound95(stated) / kNinetyFive;
    }
    const Eigen::MatrixXd apart = jackknifeDeviations(changes, factor);
    return std::max(lengthBound95(stated), lengthBound95(apart * apart.transpose())) / kNinetyFive;
  };
  return {bound(CameraQuantity::CenterX, centers), bound(CameraQuantity::TurnX, turns)};
}

/// A matrix whose product with its transpose is the covariance.
Eigen::MatrixXd root(const Eigen::MatrixXd& covariance) {
  const auto eigen = geometry::symmetricEigen(covariance);
  return eigen.eigenvectors * eigen.eigenvalues.cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

/// The distance that 95 % of the drawn errors keep below. A change of size leaves `middle` where it
/// is.
double percentile95(const PositionErrors& errors, const Eigen::MatrixXd& perDraw, double scaleSigma,
                    double pixelSigma, const Eigen::Vector3d& middle) {
  std::vector<Eigen::Matrix3d> noise;
  for (std::size_t i = 0; i < errors.positions.size(); ++i) {
    noise.emplace_back(pixelSigma * root(errors.noiseCovariances[i]));
  }
  std::vector<double> distances;
  for (std::uint32_t draw = 0; draw < kDraws; ++draw) {
    const RandomStream random(1, draw, 0, RandomPurpose::Simulation);
    Eigen::VectorXd numbers(perDraw.cols());
    for (Eigen::Index k = 0; k < numbers.size(); ++k) {
      numbers[k] = random.normal4(static_cast<std::uint32_t>(k))[0];
    }
    const Eigen::VectorXd moved = perDraw * numbers;
    const double size = scaleSigma * random.normal4(0, 1)[0];
    for (std::size_t i = 0; i < errors.positions.size(); ++i) {
      const auto own = random.normal4(static_cast<std::uint32_t>(i), 2);
      distances.push_back((moved.segment<3>(static_cast<Eigen::Index>(3 * i)) +
                           size * (errors.positions[i] - middle) +
                           noise[i] * Eigen::Vector3d(own[0], own[1], own[2]))
                              .norm());
    }
  }
  // Not quantile(): one of the distances, no value between two, and without sorting them all.
  const auto at =
      distances.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(distances.size()));
  std::nth_element(distances.begin(), at, distances.end());
  return *at;
}

/// What the errors of positions come from.
struct ErrorSources {
  bool sizeless = false;            ///< the size is a convention
  const Eigen::MatrixXd& deviation; ///< of the camera parameters: a root of their covariance
  const BlockJackknife& blocks;
  const Eigen::MatrixXd& apart; ///< deviations of the blocks' solutions where the target was
  double scaleSigma = 0.0;
  double pixelSigma = 0.0;
};

double typicalSigma(const BundleProblem& problem) {
  std::vector<double> sigmas;
  for (const BundleObservation& seen : problem.observations) {
    sigmas.push_back(seen.sigma);
  }
  return upperMedian(std::move(sigmas));
}

/// How well touches of the floor show where up is: their scatter over how far they are apart.
std::optional<double> upFromFloor(const WandResult& result, const std::vector<double>& times) {
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  std::vector<Eigen::Vector2d> touches;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const double time : times) {
    if (const auto position = ballPositionAt(result.bundle, time)) {
      touches.emplace_back(position->head<2>());
      middle += touches.back();
    }
  }
  const auto count = static_cast<double>(touches.size());
  if (touches.size() < 3) {
    return std::nullopt;
  }
  for (const Eigen::Vector2d& touch : touches) {
    spread += (touch - middle / count) * (touch - middle / count).transpose();
  }
  const double scatter =
      touches.size() > 3 ? result.floorRmsDistance * std::sqrt(count / (count - 3.0)) : 0.0;
  const double least = geometry::symmetricEigen2(spread).values[0];
  return std::max(scatter, kTouchSigma) / std::sqrt(std::max(least, 1e-9));
}

/// Positions that two cameras see, outside the box in which the target was.
struct OutsidePositions {
  std::vector<Eigen::Vector3d> positions;
  double distance = 0.0; ///< CalibrationAccuracy::outsideRegionDepth
};

OutsidePositions outsidePositions(const BundleProblem& problem, const BundleResult& result) {
  const auto seen = observedPositions(problem, result);
  const PrincipalBox box = principalBox(seen, kOutliers);
  OutsidePositions outside;
  std::vector<double> distances;
  for (const Eigen::Vector3d& position : findCommonView(result.cameras, seen).positions) {
    if (const double distance = box.distanceTo(position); distance > 0.0) {
      outside.positions.push_back(position);
      distances.push_back(distance);
    }
  }
  if (outside.positions.size() < kFewestOutside) {
    return {};
  }
  std::ranges::sort(distances);
  outside.distance = quantile(distances, kOutsideWithin);
  outside.positions = chooseEvenly(outside.positions, kPositions);
  return outside;
}

/// Where nothing was observed, errors are those of the cameras relative to where the target was.
void assessOutside(const BundleProblem& problem, const BundleResult& result,
                   const PositionErrors& inside, const ErrorSources& from,
                   CalibrationAccuracy& accuracy) {
  const OutsidePositions outside = outsidePositions(problem, result);
  const PositionErrors errors = propagateErrorsTo(outside.positions, result);
  if (errors.positions.empty()) {
    return;
  }
  const auto apart = [&](const Eigen::MatrixXd& here, const Eigen::MatrixXd& there) {
    return removeRigidMotionOf(inside.positions, here, from.sizeless, errors.positions, there);
  };
  const Eigen::MatrixXd stated =
      apart(inside.cameraJacobian, errors.cameraJacobian) * from.deviation;
  const Eigen::MatrixXd found =
      apart(from.apart,
            jackknifeDeviations(positionChanges(errors.positions, result.cameras, from.blocks.rigs),
                                from.blocks.deviationScale()));
  const Eigen::MatrixXd& larger = found.norm() > stated.norm() ? found : stated;
  accuracy.outsidePositionError95 = std::max(
      accuracy.positionError95,
      percentile95(errors, larger, from.scaleSigma, from.pixelSigma, meanVector(inside.positions)));
  accuracy.outsideRegionDepth = outside.distance;
}

} // namespace

Result<CalibrationAccuracy> assessCalibration(const BundleProblem& problem,
                                              const BundleResult& result,
                                              const AccuracyPriors& known) {
  const PositionErrors errors = propagateToPositions(problem, result, kPositions);
  if (result.covariance.columns.empty() || errors.positions.size() < 4) {
    return failure(ErrorCode::Undetermined, "", "accuracy",
                   "no cameras were adjusted, or two cameras saw too few common positions");
  }
  const bool sizeless =
      result.covariance.gaugeFreedomCount % 2 == 1; // 1 or 7: size is a convention
  const Eigen::MatrixXd perCamera =
      removeRigidMotion(errors.positions, errors.cameraJacobian, sizeless);
  const double noise = std::max(result.residualToSigmaRatio, 1e-9);
  const Eigen::MatrixXd deviation = noise * root(result.covariance.matrix);
  BlockJackknife blocks =
      leaveOutBlocks(problem, result, known.estimateInitialCamerasWithoutStates);
  const double factor = blocks.deviationScale();
  const Eigen::MatrixXd changes = positionChanges(errors.positions, result.cameras, blocks.rigs);
  const Eigen::MatrixXd apart = jackknifeDeviations(changes, factor);
  const Eigen::MatrixXd stated = perCamera * deviation;
  const Eigen::MatrixXd found = removeRigidMotion(errors.positions, apart, sizeless);
  CalibrationAccuracy accuracy;
  accuracy.crossValidationErrorRatio = ratioOf(found, stated);
  accuracy.errorInflationFactor = accuracy.crossValidationErrorRatio > kClearlyLarger
                                      ? accuracy.crossValidationErrorRatio
                                      : 1.0;
  accuracy.leftOutPointCount = blocks.leftOutPointCount;
  accuracy.leftOutRmsPx =
      blocks.leftOutPointCount > 0
          ? std::sqrt(blocks.squaredErrorSum / static_cast<double>(blocks.leftOutPointCount))
          : 0.0;
  const double scale = known.isScaleKnown ? known.scaleSigma : 0.0;
  const double pixels = noise * typicalSigma(problem);
  const Eigen::MatrixXd& larger = found.norm() > stated.norm() ? found : stated;
  const Eigen::Vector3d middle = meanVector(errors.positions);
  accuracy.positionErrorFromCameras95 = percentile95(errors, larger, scale, 0.0, middle);
  accuracy.positionError95 = percentile95(errors, larger, scale, pixels, middle);
  assessOutside(problem, result, errors, {sizeless, deviation, blocks, apart, scale, pixels},
                accuracy);
  if (known.isScaleKnown && (!sizeless || known.scaleSigma > 0.0)) {
    const auto size = [&](const Eigen::MatrixXd& of) {
      return sizeless ? 0.0 : sizeChange(errors.positions, of).norm();
    };
    accuracy.scaleError95 =
        kNinetyFive * std::hypot(std::max(size(errors.cameraJacobian * deviation), size(apart)),
                                 known.scaleSigma);
  }
  if (result.covariance.gaugeFreedomCount >= 6) {
    alignSolutions(errors, changes, sizeless, blocks.rigs);
  }
  for (std::size_t c = 0; c < result.cameras.size(); ++c) {
    accuracy.cameras.push_back(accuracyOf(c, result, blocks.rigs, factor));
  }
  if (known.upSigma) {
    accuracy.upAngleError95 = kNinetyFivePlane * *known.upSigma;
  }
  return accuracy;
}

Result<CalibrationAccuracy> assessWand(const WandResult& result,
                                       const std::vector<double>& floorTimes) {
  AccuracyPriors known;
  known.isScaleKnown = result.scaleMethod != WandScale::InitialRig;
  known.scaleSigma = result.scaleSigma;
  if (result.isFloorFound) {
    known.upSigma = upFromFloor(result, floorTimes);
  } else if (result.freeFall) {
    known.upSigma = result.freeFall->gravitySigma / kGravity;
  }
  return assessCalibration(result.problem, result.bundle, known);
}

std::string accuracySummary(const CalibrationAccuracy& accuracy) {
  std::string text =
      fmt::format("In this volume {} (95 %)", lengthUncertaintyText(accuracy.positionError95));
  text +=
      ", scale " + (accuracy.scaleError95 ? uncertaintyText(inPercent(*accuracy.scaleError95), "%")
                                          : std::string("unknown"));
  text += ", up " + (accuracy.upAngleError95
                         ? uncertaintyText(inDegrees(*accuracy.upAngleError95), "degrees")
                         : std::string("not measured"));
  text += ".";
  if (accuracy.outsidePositionError95) {
    text += fmt::format(" Outside it, up to {:.1f} m away, {} (extrapolated).",
                        accuracy.outsideRegionDepth,
                        lengthUncertaintyText(*accuracy.outsidePositionError95));
  }
  return text;
}

} // namespace dewpoint::calibration
