// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/surface/surface_pattern.h"

#include <Eigen/Core>

#include <limits>
#include <memory>

namespace dewpoint::simulation {

/// Shape of a part of a moving body. All shapes are convex.
enum class MovingShape {
  Ellipsoid, ///< size: semi-axes
  Capsule,   ///< rod with round ends along Z; size: (radius, unused, half length without the ends)
  Frustum,   ///< cone or cylinder along Z; size: (radius at -Z, radius at +Z, half height)
  Box,       ///< size: half sizes
};

/// Part of a moving body at one time. World frame or frame of the body, meters.
struct MovingPart {
  MovingShape shape = MovingShape::Ellipsoid;
  Vector3f center{0.0F, 0.0F, 0.0F};
  Vector3f size{0.01F, 0.01F, 0.01F}; ///< size along the part's own axes, see MovingShape
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity(); ///< the part's axes in the world, as rows
  Vector3f color{128.0F, 128.0F, 128.0F};             ///< BGR in full light, [0, 255]
  /// Pattern of the surface; null: `color` everywhere.
  std::shared_ptr<const SurfacePattern> pattern;
  Gloss gloss;
  /// True if the part belongs to the target. Needed only if the target is not the whole body.
  bool belongsToTarget = false;

  /// Returns the surface color where the normal (unit vector, world frame) is `normal`.
  Vector3f colorAt(const Vector3f& normal) const {
    return pattern ? pattern->colorAt(axes * normal, color) : color;
  }
};

/// Returns the radius in meters of a sphere around a part's center that contains the part.
float boundingRadius(const MovingPart& part);

/// Returns the volume of a part in cubic meters.
double volumeOf(const MovingPart& part);

/// Returns whether a point (world frame, meters) is inside the part or on its surface.
bool contains(const MovingPart& part, const Vector3f& point);

/// First intersection of a ray with one of several parts.
struct PartHit {
  /// Distance from the ray's origin to the intersection, meters.
  float distance = std::numeric_limits<float>::infinity();
  Vector3f normal{0.0F, 0.0F, 1.0F}; ///< surface normal at the intersection, world frame, outward
  const MovingPart* part = nullptr;  ///< part that the ray hits; null: no intersection
};

/// Replaces `hit` by the intersection of a ray with `part` if the ray enters `part` before the
/// current hit. `direction` is a unit vector. A ray that begins inside the part does not hit this
/// part.
void intersectPart(const MovingPart& part, const Vector3f& origin, const Vector3f& direction,
                   PartHit& hit);

} // namespace dewpoint::simulation
