// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/surface/surface_pattern.h"

#include <Eigen/Core>

#include <limits>
#include <memory>

namespace dewpoint::simulation {

/// Shapes of the parts of a moving body. All are convex.
enum class MovingShape {
  Ellipsoid, ///< size: its semi-axes
  Capsule, ///< a rod with round ends along Z; size: (radius, unused, half length without the ends)
  Frustum, ///< a cone or a cylinder along Z; size: (radius at -Z, radius at +Z, half height)
  Box,     ///< size: its half sizes
};

/// One part of a body at one instant, in meters.
struct MovingPart {
  MovingShape shape = MovingShape::Ellipsoid;
  Vector3f center{0.0F, 0.0F, 0.0F};
  Vector3f size{0.01F, 0.01F, 0.01F};                 ///< see MovingShape; along its own axes
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity(); ///< rows: its own axes in the world
  Vector3f color{128.0F, 128.0F, 128.0F};             ///< BGR in full light, [0, 255]
  std::shared_ptr<const SurfacePattern> pattern;      ///< null: `color` everywhere
  Gloss gloss;
  bool target = false; ///< belongs to the target, if that is not the center of the whole body

  /// Returns the color of its surface where the normal (unit vector, world frame) is `normal`.
  Vector3f colorAt(const Vector3f& normal) const {
    return pattern ? pattern->colorAt(axes * normal, color) : color;
  }
};

/// Returns the radius in meters of a sphere around a part's center that contains the part.
float boundOf(const MovingPart& part);

/// Returns the volume in cubic meters.
double volumeOf(const MovingPart& part);

/// Returns whether a point (world frame, meters) is in the part or on its surface.
bool contains(const MovingPart& part, const Vector3f& point);

/// First intersection of a ray with one of several parts.
struct PartHit {
  float distance = std::numeric_limits<float>::infinity(); ///< along the unit direction, meters
  Vector3f normal{0.0F, 0.0F, 1.0F};                       ///< world frame, outward
  const MovingPart* part = nullptr;                        ///< null: no intersection
};

/// Sets the hit to `part` if the ray enters it before the present hit. `direction` is a unit
/// vector. A ray that begins inside a part does not hit it.
void castPart(const MovingPart& part, const Vector3f& origin, const Vector3f& direction,
              PartHit& hit);

} // namespace dewpoint::simulation
