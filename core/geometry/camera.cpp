// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/camera.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::geometry {

Eigen::Vector3d Camera::center() const {
  return cameraFromWorld.inverse().translation();
}

Eigen::Vector3d Camera::opticalAxis() const {
  return cameraFromWorld.linear().row(2).transpose();
}

bool Camera::operator==(const Camera& other) const {
  return name == other.name && intrinsics == other.intrinsics && distortion == other.distortion &&
         lens == other.lens && cameraFromWorld.matrix() == other.cameraFromWorld.matrix();
}

bool Camera::hasDistortion() const {
  return lens != LensModel::Pinhole ||
         std::any_of(distortion.begin(), distortion.end(), [](double k) { return k != 0.0; });
}

Camera withoutPose(Camera camera) {
  camera.cameraFromWorld.setIdentity();
  return camera;
}

Eigen::Isometry3d lookAt(const Eigen::Vector3d& position, const Eigen::Vector3d& target,
                         const Eigen::Vector3d& up, double roll) {
  const Eigen::Vector3d toTarget = target - position;
  const Eigen::Vector3d forward =
      toTarget.norm() > 0.0 ? toTarget.normalized() : Eigen::Vector3d::UnitX().eval();
  Eigen::Vector3d right = forward.cross(up);
  if (right.norm() < 1e-9 * up.norm() || !(up.norm() > 0.0)) {
    right = forward.unitOrthogonal(); // looking straight along `up`: any right-hand axis will do
  }
  right.normalize();
  Eigen::Matrix3d axes;
  axes.row(0) = right.transpose();
  axes.row(1) = forward.cross(right).transpose();
  axes.row(2) = forward.transpose();
  // The camera turns by +roll about its own z, so coordinates seen from it turn by -roll.
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(-roll, Eigen::Vector3d::UnitZ()).toRotationMatrix() * axes;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation;
  pose.translation() = -rotation * position;
  return pose;
}

} // namespace dewpoint::geometry
