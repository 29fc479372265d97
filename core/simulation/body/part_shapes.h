// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/body/moving_part.h"

#include <Eigen/Core>

namespace dewpoint::simulation {

/// Returns a rod with round ends whose axis connects two points. Lengths in meters; `color` is BGR.
MovingPart capsuleBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
                          const Vector3f& color);

/// Returns a cone or cylinder whose axis connects two points, with a radius at each end. Meters.
MovingPart frustumBetween(const Eigen::Vector3d& from, double fromRadius, const Eigen::Vector3d& to,
                          double toRadius, const Vector3f& color);

/// Returns an ellipsoid whose axes are parallel to the world axes. Meters.
MovingPart ellipsoidAt(const Eigen::Vector3d& center, const Eigen::Vector3d& semiAxes,
                       const Vector3f& color);

/// Returns a ball (radius in meters) around the origin. The surface is matte with a faint
/// highlight, like that of plain balls, which are drawn without parts.
MovingPart ballPart(double radius, const Vector3f& color);

/// Returns the part after the rotation `rotation` about the origin and then a translation by
/// `shift` (meters).
MovingPart movedPart(MovingPart part, const Eigen::Matrix3d& rotation,
                     const Eigen::Vector3d& shift);

} // namespace dewpoint::simulation
