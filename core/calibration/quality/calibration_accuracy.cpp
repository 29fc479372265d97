// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/quality/calibration_accuracy.h"

#include "core/base/random.h"
#include "core/base/statistics.h"
#include "core/base/uncertainty_text.h"
#include "core/base/units.h"
#include "core/calibration/quality/position_error.h"
#include "core/calibration/wand/wand_gauge.h"
#include "core/geometry/linear_algebra.h"
#include "core/geometry/small_matrices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Positions that errors are carried to.
constexpr std::size_t kPositions = 80;
/// Draws that the 95 % are read off.
constexpr std::uint32_t kDraws = 200;
/// Solutions, each without a fifth of the stretches.
constexpr std::size_t kFolds = 5;
/// Stretches of neighboring instants, left out as wholes.
constexpr std::size_t kStretches = 20;
constexpr double kClearlyLarger = 1.5;    ///< five solutions scatter by chance up to here
constexpr double kNinetyFive = 1.96;      ///< standard deviations, one axis
constexpr double kNinetyFivePlane = 2.45; ///< two axes: sqrt(-2 log 0.05)
/// m/s², of a fall.
constexpr double kGravity = 9.81;    ///< m/s²
constexpr double kTouchSigma = 1e-3; ///< meters: how well a ball is held on the floor

/// The instants whose stretch is (or is not) of a fold, with their observations.
BundleProblem stretches(const BundleProblem& problem, std::size_t fold, bool ofFold) {
  BundleProblem part = problem;
  part.states.clear();
  part.observations.clear();
  constexpr std::size_t kNone = ~std::size_t{0};
  std::vector<std::size_t> renamed(problem.states.size(), kNone);
  for (std::size_t s = 0; s < problem.states.size(); ++s) {
    const std::size_t stretch = s * kStretches / problem.states.size();
    const bool left = stretch % kFolds == fold && !problem.states[s].fixed;
    if (left == ofFold || problem.states[s].fixed) {
      renamed[s] = part.states.size();
      part.states.push_back(problem.states[s]);
    }
  }
  for (BundleObservation seen : problem.observations) {
    seen.state = renamed[seen.state];
    if (seen.state != kNone) {
      part.observations.push_back(seen);
    }
  }
  return part;
}

/// The left-out instants with cameras that did not see them: only the target is free.
Result<BundleResult> heldOut(BundleProblem part, const BundleResult& without) {
  for (std::size_t c = 0; c < part.cameras.size(); ++c) {
    BundleCamera known;
    known.camera = without.cameras[c];
    known.poseFixed = true;
    known.offset = without.offsets[c];
    part.cameras[c] = known;
  }
  part.draft = true;
  return adjustBundle(part);
}

/// What leaving out instants shows.
struct Folds {
  Eigen::MatrixXd changes; ///< of the cameras, one column per fold that could be solved
  double squares = 0.0;    ///< pixels
  std::size_t points = 0;
};

Folds leaveOut(const BundleProblem& problem, const BundleResult& result) {
  Folds folds;
  const auto& columns = result.covariance.columns;
  folds.changes.resize(static_cast<Eigen::Index>(columns.size()), 0);
  for (std::size_t fold = 0; fold < kFolds; ++fold) {
    BundleProblem rest = stretches(problem, fold, false);
    rest.draft = true;
    const auto without = adjustBundle(rest);
    if (!without) {
      continue; // too little left: says nothing about the whole
    }
    folds.changes.conservativeResize(Eigen::NoChange, folds.changes.cols() + 1);
    folds.changes.rightCols<1>() = cameraDifference(columns, result, *without);
    if (const auto held = heldOut(stretches(problem, fold, true), *without)) {
      folds.squares += held->rms * held->rms * static_cast<double>(held->used);
      folds.points += held->used;
    }
  }
  return folds;
}

/// Jackknife variance over predicted variance of the places, as standard deviations.
double changeRatio(const Eigen::MatrixXd& perCamera, const Eigen::MatrixXd& covariance,
                   const Eigen::MatrixXd& changes) {
  const auto count = static_cast<double>(changes.cols());
  if (changes.cols() < 3) {
    return 0.0;
  }
  const Eigen::MatrixXd moved = perCamera * changes;
  const Eigen::MatrixXd about = moved.colwise() - moved.rowwise().mean();
  const double empirical = (count - 1.0) / count * about.squaredNorm();
  const double predicted = (perCamera * covariance * perCamera.transpose()).trace();
  return predicted > 0.0 ? std::sqrt(empirical / predicted) : 0.0;
}

/// A matrix whose product with its transpose is the covariance.
Eigen::MatrixXd root(const Eigen::MatrixXd& covariance) {
  const auto eigen = geometry::symmetricEigen(covariance);
  return eigen.vectors * eigen.values.cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

/// The distance that 95 % of the drawn errors keep below.
double percentile95(const PositionErrors& errors, const Eigen::MatrixXd& perDraw, double scaleSigma,
                    double pixelSigma) {
  std::vector<Eigen::Matrix3d> noise;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < errors.positions.size(); ++i) {
    noise.emplace_back(pixelSigma * root(errors.noise[i]));
    middle += errors.positions[i] / static_cast<double>(errors.positions.size());
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
      touches.size() > 3 ? result.floorRms * std::sqrt(count / (count - 3.0)) : 0.0;
  const double least = geometry::symmetricEigen2(spread).values[0];
  return std::max(scatter, kTouchSigma) / std::sqrt(std::max(least, 1e-9));
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
  const bool sizeless = result.covariance.gaugeFreedoms % 2 == 1; // 1 or 7: size is a convention
  const Eigen::MatrixXd perCamera =
      removeRigidMotion(errors.positions, errors.fromCameras, sizeless);
  const double noise = std::max(result.noiseFactor, 1e-9);
  const Eigen::MatrixXd covariance = noise * noise * result.covariance.matrix;
  const Folds folds = leaveOut(problem, result);
  CalibrationAccuracy accuracy;
  accuracy.changeRatio = changeRatio(perCamera, covariance, folds.changes);
  accuracy.modelFactor = accuracy.changeRatio > kClearlyLarger ? accuracy.changeRatio : 1.0;
  accuracy.heldOut = folds.points;
  accuracy.heldOutPx =
      folds.points > 0 ? std::sqrt(folds.squares / static_cast<double>(folds.points)) : 0.0;
  const Eigen::MatrixXd deviation = accuracy.modelFactor * root(covariance);
  const double scale = known.scaleKnown ? known.scaleSigma : 0.0;
  accuracy.cameras95 = percentile95(errors, perCamera * deviation, scale, 0.0);
  accuracy.position95 =
      percentile95(errors, perCamera * deviation, scale, noise * typicalSigma(problem));
  if (known.scaleKnown && (!sizeless || known.scaleSigma > 0.0)) {
    const double found =
        sizeless ? 0.0 : sizeChange(errors.positions, errors.fromCameras * deviation).norm();
    accuracy.scale95 = kNinetyFive * std::hypot(found, known.scaleSigma);
  }
  if (known.upSigma) {
    accuracy.up95 = kNinetyFivePlane * *known.upSigma;
  }
  return accuracy;
}

Result<CalibrationAccuracy> assessWand(const WandResult& result,
                                       const std::vector<double>& floorTimes) {
  AccuracyPriors known;
  known.scaleKnown = result.scale != WandScale::InitialRig;
  known.scaleSigma = result.scaleSigma;
  if (result.floorFound) {
    known.upSigma = upFromFloor(result, floorTimes);
  } else if (result.freeFall) {
    known.upSigma = result.freeFall->sigma / kGravity;
  }
  return assessCalibration(result.problem, result.bundle, known);
}

std::string accuracySummary(const CalibrationAccuracy& accuracy) {
  std::string text =
      fmt::format("In this volume {} (95 %)", lengthUncertaintyText(accuracy.position95));
  text += ", scale " + (accuracy.scale95 ? uncertaintyText(inPercent(*accuracy.scale95), "%")
                                         : std::string("unknown"));
  text += ", up " + (accuracy.up95 ? uncertaintyText(inDegrees(*accuracy.up95), "degrees")
                                   : std::string("not measured"));
  return text + ".";
}

} // namespace dewpoint::calibration
