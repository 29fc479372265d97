// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/manual/interactive_pose.h"

#include "core/geometry/ray.h"
#include "core/geometry/rotation_vector.h"

#include <cmath>

namespace dewpoint::calibration {
namespace {

/// Rotates what is seen: a point at p in the camera's frame comes to `rotation` p.
Camera rotatedBy(const Camera& camera, const Eigen::Matrix3d& rotation) {
  Camera result = camera;
  result.cameraFromWorld.linear() = rotation * camera.cameraFromWorld.linear();
  result.cameraFromWorld.translation() = rotation * camera.cameraFromWorld.translation();
  return result;
}

} // namespace

Camera moved(const Camera& camera, const Eigen::Vector3d& meters, NudgeFrame frame) {
  const Eigen::Vector3d inCamera =
      frame == NudgeFrame::Camera ? meters : camera.cameraFromWorld.linear() * meters;
  Camera result = camera;
  result.cameraFromWorld.translation() -= inCamera;
  return result;
}

Camera rotated(const Camera& camera, const Eigen::Vector3d& rotation, NudgeFrame frame) {
  const Eigen::Vector3d inCamera =
      frame == NudgeFrame::Camera ? rotation : camera.cameraFromWorld.linear() * rotation;
  return rotatedBy(camera, rotationFromVector(-inCamera)); // what it sees turns the other way
}

Camera zoomed(const Camera& camera, double factor) {
  Camera result = camera;
  result.intrinsics.focalX *= factor;
  result.intrinsics.focalY *= factor;
  return result;
}

Heading headingOf(const Camera& camera) {
  constexpr double kUpright = 1e-9; // nearer to the vertical there is no heading
  const Eigen::Matrix3d& axes = camera.cameraFromWorld.linear();
  const Eigen::Vector3d right = axes.row(0);
  const Eigen::Vector3d down = axes.row(1);
  const Eigen::Vector3d forward = axes.row(2);
  Heading heading;
  heading.pitch = std::atan2(forward.z(), forward.head<2>().norm());
  if (forward.head<2>().norm() < kUpright) {
    heading.yaw = std::atan2(right.x(), -right.y());
    return heading;
  }
  heading.yaw = std::atan2(forward.y(), forward.x());
  const Eigen::Vector3d level(std::sin(heading.yaw), -std::cos(heading.yaw), 0.0);
  // Rolled by r, the right-hand axis is cos r * level + sin r * (down at no roll).
  heading.roll = std::atan2(-level.dot(down), level.dot(right));
  return heading;
}

Camera withHeading(const Camera& camera, const Heading& heading) {
  const double level = std::cos(heading.pitch);
  const Eigen::Vector3d forward(level * std::cos(heading.yaw), level * std::sin(heading.yaw),
                                std::sin(heading.pitch));
  const Eigen::Vector3d right(std::sin(heading.yaw), -std::cos(heading.yaw), 0.0);
  Eigen::Matrix3d axes;
  axes.row(0) = right.transpose();
  axes.row(1) = forward.cross(right).transpose();
  axes.row(2) = forward.transpose();
  const Eigen::Vector3d center = camera.center();
  Camera result = camera;
  result.cameraFromWorld.linear() =
      Eigen::AngleAxisd(-heading.roll, Eigen::Vector3d::UnitZ()).toRotationMatrix() * axes;
  return withPosition(result, center);
}

Camera withPosition(const Camera& camera, const Eigen::Vector3d& position) {
  Camera result = camera;
  result.cameraFromWorld.translation() = -(camera.cameraFromWorld.linear() * position);
  return result;
}

Eigen::Vector3d aimPoint(const Camera& camera, double height) {
  constexpr double kFarthest = 100.0; // meters
  const Eigen::Vector3d center = camera.center();
  const Eigen::Vector3d axis = camera.opticalAxis();
  const double distance = (height - center.z()) / axis.z();
  const bool meets = distance > 0.0 && distance <= kFarthest; // false for a level axis
  return center + (meets ? distance : 1.0) * axis;
}

Camera lookingAt(const Camera& camera, const Eigen::Vector3d& target) {
  const Eigen::Vector3d center = camera.center();
  const Eigen::Vector3d way = target - center;
  if (!(way.norm() > 1e-6)) {
    return camera;
  }
  Heading heading = headingOf(camera);
  heading.pitch = std::atan2(way.z(), way.head<2>().norm());
  if (way.head<2>().norm() > 1e-9) {
    heading.yaw = std::atan2(way.y(), way.x());
  }
  return withHeading(camera, heading);
}

ReferenceGrid referenceGridFor(const CameraRig& rig) {
  constexpr double kSteps[] = {0.01, 0.02, 0.05, 0.1, 0.2, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0};
  /// Grid lines in the cameras' distance.
  constexpr double kLinesPerDistance = 8.0;
  /// Along each side.
  constexpr int kCells = 10;
  ReferenceGrid grid;
  if (rig.empty()) {
    return grid;
  }
  std::vector<Ray> axes;
  for (const Camera& camera : rig) {
    axes.push_back({camera.center(), camera.opticalAxis()});
  }
  // What they all look at; a single camera looks at the floor.
  const Eigen::Vector3d middle = nearestPoint(axes).value_or(aimPoint(rig.front(), 0.0));
  double distance = 0.0;
  for (const Camera& camera : rig) {
    distance += (middle - camera.center()).norm() / static_cast<double>(rig.size());
  }
  grid.step = kSteps[0];
  for (const double step : kSteps) {
    grid.step = step <= distance / kLinesPerDistance ? step : grid.step;
  }
  constexpr int kHalf = kCells / 2;
  grid.size = Eigen::Vector3d(kCells, kCells, kHalf) * grid.step;
  for (int axis = 0; axis < 2; ++axis) {
    grid.origin[axis] = (std::round(middle[axis] / grid.step) - kHalf) * grid.step;
  }
  grid.origin.z() = 0.0;
  return grid;
}

double fieldOfView(const Camera& camera) {
  const Intrinsics& in = camera.intrinsics;
  return camera.lens == LensModel::Fisheye ? in.width / in.focalX
                                           : 2.0 * std::atan(in.width / (2.0 * in.focalX));
}

double focalLengthOf(const Camera& camera, double fieldOfView) {
  const Intrinsics& in = camera.intrinsics;
  return camera.lens == LensModel::Fisheye ? in.width / fieldOfView
                                           : in.width / (2.0 * std::tan(fieldOfView / 2.0));
}

Camera withFocalLength(const Camera& camera, double focalX) {
  Camera result = zoomed(camera, focalX / camera.intrinsics.focalX);
  result.intrinsics.focalX = focalX;
  return result;
}

} // namespace dewpoint::calibration
