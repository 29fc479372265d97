// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/surface/solid.h"

#include <cstdint>

namespace dewpoint::simulation {

/// Returns a hash of three integers.
std::uint32_t hashOfIntegers(std::uint32_t x, std::uint32_t y, std::uint32_t z);

/// Returns smooth random noise ("value noise") at a position, in [-1, 1]. The noise is random at
/// the points of the integer grid and varies smoothly between these points.
float valueNoise(const Vector3f& position);

/// Returns the color (BGR) of a patterned surface at a point in the solid's own frame, meters.
/// `color` is the basic color of the surface.
Vector3f textureColor(Pattern pattern, const Vector3f& color, const Vector3f& position);

} // namespace dewpoint::simulation
