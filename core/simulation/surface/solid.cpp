// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/surface/solid.h"

#include <cmath>

namespace dewpoint::simulation {

Solid makeSolid(Shape shape, const Vector3f& center, const Vector3f& halfSize,
                const Material& material, float yaw) {
  return {shape, center, halfSize, yaw, material, std::cos(yaw), std::sin(yaw), halfSize.norm()};
}

} // namespace dewpoint::simulation
