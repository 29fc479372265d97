// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::geometry {

/// The rotation of a rotation vector (Rodrigues), radians: its direction is the axis, its length
/// the angle.
Eigen::Matrix3d rotationOfVector(const Eigen::Vector3d& vector);

/// The rotation vector of a rotation matrix; its length is within 0 to pi.
Eigen::Vector3d vectorOfRotation(const Eigen::Matrix3d& rotation);

} // namespace dewpoint::geometry
