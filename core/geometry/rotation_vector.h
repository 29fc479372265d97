// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::geometry {

/// Converts a rotation vector to a rotation matrix (Rodrigues). The direction of the vector is the
/// axis, and its length is the angle in radians.
Eigen::Matrix3d rotationFromVector(const Eigen::Vector3d& vector);

/// Converts a rotation matrix to a rotation vector, whose length is between 0 and pi.
Eigen::Vector3d vectorFromRotation(const Eigen::Matrix3d& rotation);

/// Returns the angle of the rotation from one orientation to the other, in radians from 0 to pi.
double angleBetween(const Eigen::Matrix3d& one, const Eigen::Matrix3d& other);

} // namespace dewpoint::geometry
