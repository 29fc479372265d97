// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/rotation_vector.h"

#include <Eigen/Geometry>

namespace dewpoint::geometry {

Eigen::Matrix3d rotationFromVector(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  return angle > 0.0 ? Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix()
                     : Eigen::Matrix3d::Identity();
}

Eigen::Vector3d vectorFromRotation(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd angleAxis(rotation);
  return angleAxis.angle() * angleAxis.axis();
}

double angleBetween(const Eigen::Matrix3d& one, const Eigen::Matrix3d& other) {
  return Eigen::AngleAxisd(one * other.transpose()).angle();
}

} // namespace dewpoint::geometry
