// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::simulation {

using Eigen::Vector3f;

enum class Pattern { Plain, Wood, Plaster, Skin, Floor, Pages };

/// What a surface is made of; `color` is BGR in full light, [0, 255].
struct Material {
  Pattern pattern = Pattern::Plain;
  Vector3f color{128.0F, 128.0F, 128.0F};
};

/// A color given as people write it.
inline Vector3f rgb(float red, float green, float blue) {
  return {blue, green, red};
}

enum class Shape { Box, Ellipsoid, Cylinder };

/// An object at rest: a box, an ellipsoid or an upright cylinder, rotated about the vertical.
struct Solid {
  Shape shape = Shape::Box;
  Vector3f center;
  Vector3f halfSize; ///< semi-axes along the solid's own axes
  float yaw = 0.0F;  ///< radians about Z
  Material material;
  float cosine = 1.0F;
  float sine = 0.0F;
  float bound = 0.0F; ///< radius of a sphere around it
};

/// Makes a solid with all that follows from its size and its turn.
Solid solidOf(Shape shape, const Vector3f& center, const Vector3f& halfSize,
              const Material& material, float yaw);

/// A vector of the world in the solid's own axes.
inline Vector3f toSolid(const Solid& solid, const Vector3f& v) {
  return {solid.cosine * v.x() + solid.sine * v.y(), -solid.sine * v.x() + solid.cosine * v.y(),
          v.z()};
}

/// A vector in the solid's own axes, in the world.
inline Vector3f toWorld(const Solid& solid, const Vector3f& v) {
  return {solid.cosine * v.x() - solid.sine * v.y(), solid.sine * v.x() + solid.cosine * v.y(),
          v.z()};
}

} // namespace dewpoint::simulation
