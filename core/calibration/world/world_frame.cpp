// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/world/world_frame.h"

#include "core/geometry/mean_vector.h"
#include "core/geometry/rotation_check.h"
#include "core/geometry/rotation_vector.h"
#include "core/geometry/small_matrices.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::calibration {
namespace {

// Judgments, not tuned.
/// Points nearer to a line than this share of their distances, in the direction across it, do not
/// determine a plane.
constexpr double kOnOneLine = 0.02;
/// Length, as a share of one, that the mean of the images' upward directions must have along an
/// axis to say that this axis is up.
constexpr double kClearlyUp = 0.5;
/// The images are upright if their mean upward direction has at least this component along z.
constexpr double kUpright = 0.2;
/// Cameras whose optical axes have on average less than this component along z look down.
constexpr double kLooksDown = -0.3;

/// The rotation of the world about `pivot`.
Similarity rotationAbout(const Eigen::Vector3d& pivot, const Eigen::Matrix3d& rotation) {
  return {1.0, rotation, pivot - rotation * pivot};
}

Similarity rotationOfWorld(const Eigen::Matrix3d& rotation) {
  return rotationAbout(Eigen::Vector3d::Zero(), rotation);
}

Eigen::Matrix3d turnAboutVertical(double radians) {
  return rotationFromVector(Eigen::Vector3d(0.0, 0.0, radians));
}

/// The turn about the vertical that brings a horizontal direction onto the x axis.
Eigen::Matrix3d ontoXAxis(const Eigen::Vector3d& direction) {
  return turnAboutVertical(-std::atan2(direction.y(), direction.x()));
}

} // namespace

Result<FloorChange> changeToFloor(const std::vector<Eigen::Vector3d>& points,
                                  const CameraRig& rig) {
  if (points.size() < 3) {
    return failure(ErrorCode::Undetermined, "", "floor", "three points are needed");
  }
  const Eigen::Vector3d middle = meanVector(points);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point : points) {
    scatter += (point - middle) * (point - middle).transpose();
  }
  scatter /= static_cast<double>(points.size());
  const auto eigen = symmetricEigen3(scatter);
  if (!(eigen.values[1] > kOnOneLine * kOnOneLine * eigen.values[2])) {
    return failure(ErrorCode::Undetermined, "", "floor",
                   "the points lie on a line; spread them over the floor");
  }
  Eigen::Vector3d up = eigen.vectors.col(0);
  double above = 0.0;
  for (const Camera& camera : rig) {
    above += (camera.center() - middle).dot(up);
  }
  up *= above < 0.0 ? -1.0 : 1.0;
  const Eigen::Matrix3d level = rotationBetween(up, Eigen::Vector3d::UnitZ());
  const Eigen::Matrix3d rotation = ontoXAxis(level * (points[1] - points[0])) * level;
  // The first point's foot on the plane, not the point itself: with more than three points it is
  // seldom exactly on it.
  const Eigen::Vector3d origin = points[0] - (points[0] - middle).dot(up) * up;
  return FloorChange{{1.0, rotation, -(rotation * origin)},
                     std::sqrt(std::max(eigen.values[0], 0.0))};
}

Result<Similarity> levelingRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d line = to - from;
  const Eigen::Vector3d flat(line.x(), line.y(), 0.0);
  if (!(flat.norm() > std::abs(line.z()))) {
    return failure(ErrorCode::Undetermined, "", "level",
                   "the line between the two points is not nearly horizontal");
  }
  return rotationAbout(from, rotationBetween(line.normalized(), flat.normalized()));
}

Similarity changeToOrigin(const Eigen::Vector3d& point) {
  return {1.0, Eigen::Matrix3d::Identity(), -point};
}

Result<Similarity> changeToXAxis(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d line = to - from;
  if (!(line.head<2>().norm() > kOnOneLine * line.norm())) {
    return failure(ErrorCode::Undetermined, "", "axis", "one point is above the other");
  }
  return rotationOfWorld(ontoXAxis(line));
}

Result<Similarity> scaleToLength(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                 double meters) {
  const double present = (to - from).norm();
  if (!(meters > 0.0) || !std::isfinite(meters) || !(present > 0.0)) {
    return failure(ErrorCode::BadValue, "", "length",
                   "it must be more than zero, between two different points");
  }
  return Similarity{meters / present, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
}

Similarity quarterTurns(WorldAxis axis, int turns) {
  // Exact: a turn by a rounded pi/2 would leave traces like -1.2e-16 in every camera.
  static constexpr std::array<double, 4> kCosines{1.0, 0.0, -1.0, 0.0};
  static constexpr std::array<double, 4> kSines{0.0, 1.0, 0.0, -1.0};
  const auto quarter = static_cast<std::size_t>(((turns % 4) + 4) % 4);
  const auto a = (static_cast<Eigen::Index>(axis) + 1) % 3;
  const auto b = (static_cast<Eigen::Index>(axis) + 2) % 3;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation(a, a) = rotation(b, b) = kCosines[quarter];
  rotation(b, a) = kSines[quarter];
  rotation(a, b) = -kSines[quarter];
  return rotationOfWorld(rotation);
}

Similarity rigidMotion(const Eigen::Vector3d& shift, double turn) {
  return {1.0, turnAboutVertical(turn), shift};
}

std::optional<Similarity> uprightRotation(const CameraRig& rig) {
  if (rig.empty()) {
    return std::nullopt;
  }
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
  double ahead = 0.0;
  for (const Camera& camera : rig) {
    up -= camera.cameraFromWorld.linear().row(1).transpose();
    ahead += camera.opticalAxis().z();
  }
  up /= static_cast<double>(rig.size());
  ahead /= static_cast<double>(rig.size());
  if (up.z() >= kUpright || ahead < kLooksDown) {
    return std::nullopt;
  }
  Eigen::Index axis = 0;
  const double most = up.cwiseAbs().maxCoeff(&axis);
  if (most < kClearlyUp) {
    return std::nullopt;
  }
  switch (axis) {
  case 0: // x points up (or down): about y
    return quarterTurns(WorldAxis::Y, up.x() > 0.0 ? -1 : 1);
  case 1: // y points up (or down): about x
    return quarterTurns(WorldAxis::X, up.y() > 0.0 ? 1 : -1);
  default: // z points down
    return quarterTurns(WorldAxis::X, 2);
  }
}

} // namespace dewpoint::calibration
