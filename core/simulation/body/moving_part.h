// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/surface/surface_pattern.h"

#include <Eigen/Core>

#include <limits>
#include <memory>

namespace dewpoint::simulation {

/// The shapes that a moving body is made of. All are convex.
enum class MovingShape {
  Ellipsoid, ///< size: its semi-axes
  Capsule,   ///< a rod with round ends along Z; size: (radius, unused, half the rod without them)
  Frustum,   ///< a cone or a cylinder along Z; size: (radius at -Z, radius at +Z, half height)
  Box,       ///< size: its half sizes
};

/// One part of a body at one instant. Meters.
struct MovingPart {
  MovingShape shape = MovingShape::Ellipsoid;
  Vector3f center{0.0F, 0.0F, 0.0F};
  Vector3f size{0.01F, 0.01F, 0.01F};                 ///< see MovingShape; along its own axes
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity(); ///< rows: its own axes in the world
  Vector3f color{128.0F, 128.0F, 128.0F};             ///< BGR in full light, [0, 255]
  std::shared_ptr<const SurfacePattern> pattern;      ///< none: `color` all over
  Gloss gloss;
  bool target = false; ///< belongs to what is tracked, where that is not the whole body's center

  /// The color of its surface where the normal (unit vector, world) is `normal`.
  Vector3f colorAt(const Vector3f& normal) const {
    return pattern ? pattern->colorAt(axes * normal, color) : color;
  }
};

/// Radius of a sphere around a part's center that holds the part, meters.
float boundOf(const MovingPart& part);

/// Cubic meters.
double volumeOf(const MovingPart& part);

/// True if a point (world, meters) is in the part or on its surface.
bool contains(const MovingPart& part, const Vector3f& point);

/// Where a ray first meets one of several parts.
struct PartHit {
  float distance = std::numeric_limits<float>::infinity(); ///< along the unit direction, meters
  Vector3f normal{0.0F, 0.0F, 1.0F};                       ///< world, outwards
  const MovingPart* part = nullptr;                        ///< null: none of them
};

/// Makes `part` the hit when the ray enters it nearer than the hit so far. `direction` is a unit
/// vector; nothing is hit by a ray that begins inside.
void castPart(const MovingPart& part, const Vector3f& origin, const Vector3f& direction,
              PartHit& hit);

} // namespace dewpoint::simulation
