// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace dewpoint::color {

/// A target color as ranges in HSI (Gonzalez & Woods). Hue in degrees [0, 360), circular: hueMin >
/// hueMax wraps through 0. Saturation and intensity in [0, 1]. All bounds inclusive.
struct ColorRange {
  double hueMin = 0.0;
  double hueMax = 0.0;
  double saturationMin = 0.0;
  double saturationMax = 1.0;
  double intensityMin = 0.0;
  double intensityMax = 1.0;

  bool operator==(const ColorRange&) const = default;
};

/// True if the range spans every hue (from 0 to 360): then the hue does not matter, and gray, which
/// has none, is let through as well.
bool spansEveryHue(const ColorRange& range);

/// The hue of an angle in degrees, any number of turns away: within [0, 360).
double hueOf(double angle);

/// BadValue naming "hue", "saturation" or "intensity" when a bound is not finite or out of bounds,
/// or when no color could ever match. A hue bound of 360 is allowed: 0 to 360 is every hue.
Status checkColorRange(const ColorRange& range);

} // namespace dewpoint::color
