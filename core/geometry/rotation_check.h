// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <string>

namespace dewpoint::geometry {

/// Returns the rotation nearest to `matrix`, which may be inexact because published files often
/// round to six digits. A matrix that is a rotation to double precision is returned unchanged. If
/// the matrix is not even roughly a rotation, returns a message that explains why: its rows are not
/// orthonormal, or it is a reflection.
tl::expected<Eigen::Matrix3d, std::string> checkedRotation(const Eigen::Matrix3d& matrix);

/// Returns the smallest rotation that maps the direction of `from` to the direction of `to`.
Eigen::Matrix3d rotationBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

} // namespace dewpoint::geometry
