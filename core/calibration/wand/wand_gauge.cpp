// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/wand/wand_gauge.h"

#include "core/geometry/linear_algebra.h"
#include "core/geometry/mean_vector.h"
#include "core/geometry/rotation_check.h"
#include "core/geometry/small_matrices.h"
#include "core/geometry/sphere_image.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr double kTouchSeconds = 0.1; ///< before and after a touch, while the ball is held
/// Instants that a fall needs.
constexpr std::size_t kFewestOfFall = 5;
/// By how much all edges of a ball may lie too far in or out alike: that does not average out.
constexpr double kEdgePx = 0.05;
constexpr double kFlatEnough = 0.05; ///< meters that floor touches must spread in both directions

tl::unexpected<Error> ballNotSeenError(const char* field, double time) {
  return failure(ErrorCode::Undetermined, "", field,
                 fmt::format("the ball is not seen by two cameras at {:.2f} s", time));
}

Result<ScaleEstimate> scaleOfDistance(const WandProblem& problem, const BundleResult& now) {
  const auto first = ballPositionAt(now, problem.distance.firstTime);
  const auto second = ballPositionAt(now, problem.distance.secondTime);
  if (!first || !second) {
    return ballNotSeenError("distance",
                            first ? problem.distance.secondTime : problem.distance.firstTime);
  }
  const double seen = (*second - *first).norm();
  if (!(problem.distance.meters > 0.0) || !(seen > 0.0)) {
    return failure(ErrorCode::BadValue, "", "distance", "it must be more than zero");
  }
  // A millimeter at either end, as a hand holds a ball to a mark.
  return ScaleEstimate{problem.distance.meters / seen, 0.0015 / problem.distance.meters};
}

/// Apparent against expected radius. The median: a hidden or blurred ball is too small or large.
Result<ScaleEstimate> scaleOfDiameter(const WandProblem& problem, const BundleProblem& bundle,
                                      const BundleResult& now) {
  std::vector<SphereProjector> projectors;
  for (const Camera& camera : now.cameras) {
    projectors.emplace_back(camera);
  }
  std::vector<double> ratios;
  double pixels = 0.0;
  for (std::size_t i = 0; i < bundle.observations.size(); ++i) {
    const BundleObservation& seen = bundle.observations[i];
    const double radius = problem.ballRadii[seen.point];
    if (!std::isfinite(now.residuals[i].norm()) || !(seen.radius > 0.0) || !(radius > 0.0)) {
      continue;
    }
    const auto image =
        projectors[seen.camera].project(now.states[seen.state].ends[seen.point], radius);
    if (image) {
      ratios.push_back(image->radius / seen.radius);
      pixels += seen.radius;
    }
  }
  if (ratios.size() < 10) {
    return failure(ErrorCode::Undetermined, "", "diameter",
                   "the ball's radius is needed, in meters and in at least 10 images");
  }
  const auto count = static_cast<double>(ratios.size());
  std::sort(ratios.begin(), ratios.end());
  const auto at = [&](double share) {
    return ratios[static_cast<std::size_t>(share * (count - 1.0))];
  };
  const double spread = 0.5 * (at(0.84) - at(0.16)) / std::sqrt(count);
  return ScaleEstimate{at(0.5), std::hypot(spread, kEdgePx * count / pixels)};
}

/// Rotates `up` to Z and leaves the rest as it was.
Similarity toUpright(const Eigen::Vector3d& up) {
  Similarity change;
  change.rotation = geometry::rotationBetween(up, Eigen::Vector3d::UnitZ());
  return change;
}

/// Fits place = a + b t + c t² to the fall: acceleration 2 c.
Result<FreeFall> fall(const std::array<double, 2>& when, const BundleResult& now,
                      Eigen::Vector3d& acceleration) {
  std::vector<const BundleState*> seen;
  for (const BundleState& state : now.states) {
    if (state.isPositionKnown && state.time >= when[0] && state.time <= when[1]) {
      seen.push_back(&state);
    }
  }
  if (seen.size() < kFewestOfFall) {
    return failure(ErrorCode::Undetermined, "", "drop",
                   fmt::format("two cameras see the ball in {} frames of the fall; {} are needed",
                               seen.size(), kFewestOfFall));
  }
  const auto rows = static_cast<Eigen::Index>(seen.size());
  Eigen::MatrixXd powers(rows, 3);
  Eigen::MatrixXd positions(rows, 3);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const BundleState& state = *seen[static_cast<std::size_t>(i)];
    const double t = state.time - when[0];
    powers.row(i) << 1.0, t, t * t;
    positions.row(i) = state.ends[0].transpose();
  }
  const Eigen::MatrixXd fitted = geometry::leastSquares(powers, positions);
  acceleration = 2.0 * fitted.row(2).transpose();
  const double degreesOfFreedom = static_cast<double>(3 * std::max<Eigen::Index>(rows - 3, 1));
  const double variance = (powers * fitted - positions).squaredNorm() / degreesOfFreedom;
  const Eigen::Matrix3d inverse = (powers.transpose() * powers).inverse();
  return FreeFall{acceleration.norm(), 2.0 * std::sqrt(variance * inverse(2, 2)), seen.size()};
}

Result<Similarity> onFloor(const WandProblem& problem, const BundleResult& now,
                           const Eigen::Vector3d& fallUp, WandResult& result) {
  std::vector<Eigen::Vector3d> touches;
  for (const double time : problem.floorTimes) {
    const auto position = ballPositionAt(now, time);
    if (!position) {
      return ballNotSeenError("floor", time);
    }
    touches.push_back(*position);
  }
  const Eigen::Vector3d middle = geometry::meanVector(touches);
  Eigen::Vector3d up = fallUp;
  if (touches.size() >= 3) {
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const auto& touch : touches) {
      scatter += (touch - middle) * (touch - middle).transpose();
    }
    scatter /= static_cast<double>(touches.size());
    const auto eigen = geometry::symmetricEigen3(scatter);
    if (!(std::sqrt(eigen.values[1]) > kFlatEnough)) {
      return failure(ErrorCode::Undetermined, "", "floor",
                     "the touched positions lie on a line; spread them over the floor");
    }
    up = eigen.vectors.col(0);
    double above = 0.0;
    for (const Camera& camera : now.cameras) {
      above += (camera.center() - middle).dot(up);
    }
    up *= above < 0.0 ? -1.0 : 1.0;
    result.isFloorFound = true;
    result.floorRmsDistance = std::sqrt(std::max(eigen.values[0], 0.0));
  }
  Similarity change = toUpright(up);
  // The floor is one radius below the middles of the balls that lie on it.
  change.translation.z() = problem.ballRadii[0] - (change.rotation * middle).z();
  return change;
}

} // namespace

Similarity fitRigSimilarity(const CameraRig& from, const CameraRig& to, bool scaleFree) {
  // The size comes from the places alone; then points ahead of and above each camera, as far away
  // as the cameras are from each other, let the axes have their say.
  std::vector<Eigen::Vector3d> fromPositions, toPositions;
  for (std::size_t c = 0; c < from.size(); ++c) {
    fromPositions.push_back(from[c].center());
    toPositions.push_back(to[c].center());
  }
  const auto spread = [](const std::vector<Eigen::Vector3d>& positions) {
    double sum = 0.0;
    for (const auto& position : positions) {
      sum += (position - geometry::meanVector(positions)).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(positions.size()));
  };
  const double scale =
      scaleFree && spread(fromPositions) > 0.0 ? spread(toPositions) / spread(fromPositions) : 1.0;
  const double reach = std::max(spread(toPositions), 1e-6);
  for (std::size_t c = 0; c < from.size(); ++c) {
    for (const Eigen::Index axis : {1, 2}) {
      fromPositions.push_back(from[c].center() +
                              reach / scale *
                                  from[c].cameraFromWorld.linear().row(axis).transpose());
      toPositions.push_back(to[c].center() +
                            reach * to[c].cameraFromWorld.linear().row(axis).transpose());
    }
  }
  for (auto& position : fromPositions) {
    position *= scale;
  }
  Similarity change = fitSimilarity(fromPositions, toPositions, false);
  change.scale = scale;
  return change;
}

void moveWorld(const Similarity& change, BundleResult& result) {
  for (Camera& camera : result.cameras) {
    camera = transformed(change, camera);
  }
  for (BundleState& state : result.states) {
    for (Eigen::Vector3d& end : state.ends) {
      end = change * end;
    }
    state.worldFromBoard.linear() = change.rotation * state.worldFromBoard.linear();
    state.worldFromBoard.translation() =
        change * Eigen::Vector3d(state.worldFromBoard.translation());
  }
  const Eigen::Matrix3d turn = change.scale * change.rotation;
  Eigen::MatrixXd& matrix = result.covariance.matrix;
  for (std::size_t i = 0; i < result.covariance.columns.size(); ++i) {
    if (result.covariance.columns[i].quantity == CameraQuantity::CenterX) {
      const auto at = static_cast<Eigen::Index>(i);
      matrix.middleRows<3>(at) = (turn * matrix.middleRows<3>(at)).eval();
      matrix.middleCols<3>(at) = (matrix.middleCols<3>(at) * turn.transpose()).eval();
    }
  }
}

std::optional<Eigen::Vector3d> ballPositionAt(const BundleResult& now, double time,
                                              std::size_t ball) {
  std::vector<Eigen::Vector3d> positions;
  for (const BundleState& state : now.states) {
    if (state.isPositionKnown && std::abs(state.time - time) <= kTouchSeconds) {
      positions.push_back(state.ends[ball]);
    }
  }
  return positions.empty() ? std::nullopt : std::optional(geometry::meanVector(positions));
}

Result<ScaleEstimate> estimateScale(const WandProblem& problem, const BundleProblem& bundle,
                                    const BundleResult& now) {
  switch (problem.scaleMethod) {
  case WandScale::Distance:
    return scaleOfDistance(problem, now);
  case WandScale::Diameter:
    return scaleOfDiameter(problem, bundle, now);
  case WandScale::Stick: // a stick is measured to half a millimeter
    return ScaleEstimate{1.0, problem.stickLength > 0.0 ? 5e-4 / problem.stickLength : 0.0};
  default:
    return ScaleEstimate{};
  }
}

Result<Similarity> changeToUprightWorld(const WandProblem& problem, const BundleResult& now,
                                        WandResult& result) {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  if (problem.freeFallSpan) {
    Eigen::Vector3d acceleration;
    const auto fell = fall(*problem.freeFallSpan, now, acceleration);
    if (!fell) {
      return tl::make_unexpected(fell.error());
    }
    result.freeFall = *fell;
    up = -acceleration.normalized();
  }
  const auto change = problem.floorTimes.empty() ? Result<Similarity>(toUpright(up))
                                                 : onFloor(problem, now, up, result);
  if (change) {
    result.upCorrectionAngle = std::acos(std::clamp(change->rotation(2, 2), -1.0, 1.0));
  }
  return change;
}

} // namespace dewpoint::calibration
