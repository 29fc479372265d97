// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <string>

namespace dewpoint::geometry {

/// The nearest rotation of a matrix that is nearly one (published files carry six digits or more);
/// the same bits where it is one to double precision. Otherwise why it is none: rows that are not
/// orthonormal, or a mirror.
tl::expected<Eigen::Matrix3d, std::string> checkedRotation(const Eigen::Matrix3d& matrix);

/// The smallest rotation that takes the direction of `from` to that of `to`.
Eigen::Matrix3d rotationBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

} // namespace dewpoint::geometry
