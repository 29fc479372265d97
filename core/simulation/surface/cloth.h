// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/surface/solid.h"

namespace dewpoint::simulation {

/// Pattern of a piece of cloth.
enum class ClothPattern {
  Plain,   ///< one color
  Stripes, ///< bands of two colors across the length of a part
  Checks,  ///< fields of two colors that alternate in all directions
  Blotches ///< irregular spots of a second color
};

/// Colors of a cloth: a single color, or two colors in a pattern. BGR in full light, [0, 255].
struct Cloth {
  ClothPattern pattern = ClothPattern::Plain;
  /// Second color. The first color is stored with the part of the body that wears the cloth.
  Vector3f secondColor{0.0F, 0.0F, 0.0F};
  float patternWidth = 0.06F; ///< width of a band, field or spot, meters
};

/// Returns the color of a part at `position` (meters, along the part's own axes). `first` is the
/// first color of the cloth, and the only one if the cloth is plain.
Vector3f clothColor(const Cloth& cloth, const Vector3f& first, const Vector3f& position);

} // namespace dewpoint::simulation
