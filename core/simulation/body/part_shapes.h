// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/body/moving_part.h"

#include <Eigen/Core>

namespace dewpoint::simulation {

/// A rod with round ends whose axis goes from one point to another. Meters; `color` BGR.
MovingPart capsuleBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
                          const Vector3f& color);

/// A cone or cylinder whose axis goes from one point to another, with a radius at each end. Meters.
MovingPart frustumBetween(const Eigen::Vector3d& from, double fromRadius, const Eigen::Vector3d& to,
                          double toRadius, const Vector3f& color);

/// An ellipsoid along the world's axes. Meters.
MovingPart ellipsoidAt(const Eigen::Vector3d& center, const Eigen::Vector3d& semiAxes,
                       const Vector3f& color);

/// A ball around the origin with the surface of the plain balls: matte, with a faint highlight.
MovingPart ballPart(double radius, const Vector3f& color);

/// The part after a rotation about the origin (world from the part's old axes), then a shift.
MovingPart moved(MovingPart part, const Eigen::Matrix3d& rotation, const Eigen::Vector3d& shift);

} // namespace dewpoint::simulation
