// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::geometry {

/// Rotation matrix of a rotation vector (Rodrigues): its direction is the axis, its length the
/// angle in radians.
Eigen::Matrix3d rotationOfVector(const Eigen::Vector3d& vector);

/// Rotation vector of a rotation matrix; its length is between 0 and pi.
Eigen::Vector3d vectorOfRotation(const Eigen::Matrix3d& rotation);

/// The angle between two rotations: that of the rotation from one to the other, radians, 0 to pi.
double angleBetween(const Eigen::Matrix3d& one, const Eigen::Matrix3d& other);

} // namespace dewpoint::geometry
