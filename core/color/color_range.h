// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace dewpoint::color {

/// Color of a target as a range in HSI (Gonzalez & Woods). Hue is in degrees [0, 360) and circular:
/// hueMin > hueMax wraps through 0. Saturation and intensity are in [0, 1]. All bounds are
/// inclusive.
struct ColorRange {
  double hueMin = 0.0;
  double hueMax = 0.0;
  double saturationMin = 0.0;
  double saturationMax = 1.0;
  double intensityMin = 0.0;
  double intensityMax = 1.0;

  bool operator==(const ColorRange&) const = default;
};

/// Returns true if the range spans every hue (from 0 to 360). Then the hue does not matter, and
/// gray, which has no hue, matches as well.
bool spansEveryHue(const ColorRange& range);

/// Maps an angle in degrees, any number of turns away, to a hue within [0, 360).
double hueOf(double angle);

/// Checks a range. BadValue names "hue", "saturation" or "intensity" when a bound is not finite or
/// out of bounds, or when no color could ever match. A hue bound of 360 is allowed: 0 to 360 is
/// every hue.
Status checkColorRange(const ColorRange& range);

} // namespace dewpoint::color
