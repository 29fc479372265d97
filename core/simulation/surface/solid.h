// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::simulation {

using Eigen::Vector3f;

/// Pattern of a solid's surface.
enum class Pattern { Plain, Wood, Plaster, Skin, Floor, Pages };

/// Material of a surface; `color` is BGR in full light, [0, 255].
struct Material {
  Pattern pattern = Pattern::Plain;
  Vector3f color{128.0F, 128.0F, 128.0F};
};

/// Returns a BGR color from its red, green and blue values.
inline Vector3f rgb(float red, float green, float blue) {
  return {blue, green, red};
}

/// Shape of a solid at rest.
enum class Shape { Box, Ellipsoid, Cylinder };

/// Object at rest: a box, an ellipsoid or an upright cylinder, rotated about the vertical.
struct Solid {
  Shape shape = Shape::Box;
  Vector3f center;
  Vector3f halfSize; ///< half size along the solid's own axes, meters
  float yaw = 0.0F;  ///< rotation angle about Z, radians
  Material material;
  float yawCosine = 1.0F;      ///< cosine of `yaw`
  float yawSine = 0.0F;        ///< sine of `yaw`
  float boundingRadius = 0.0F; ///< radius of a sphere around the solid, meters
};

/// Creates a solid, including the fields that are derived from its size and rotation. Lengths are
/// in meters, `yaw` in radians.
Solid makeSolid(Shape shape, const Vector3f& center, const Vector3f& halfSize,
                const Material& material, float yaw);

/// Converts a vector from the world frame to the solid's own axes.
inline Vector3f toSolidFrame(const Solid& solid, const Vector3f& v) {
  return {solid.yawCosine * v.x() + solid.yawSine * v.y(),
          -solid.yawSine * v.x() + solid.yawCosine * v.y(), v.z()};
}

/// Converts a vector from the solid's own axes to the world frame.
inline Vector3f toWorld(const Solid& solid, const Vector3f& v) {
  return {solid.yawCosine * v.x() - solid.yawSine * v.y(),
          solid.yawSine * v.x() + solid.yawCosine * v.y(), v.z()};
}

} // namespace dewpoint::simulation
