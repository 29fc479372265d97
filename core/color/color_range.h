// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace dewpoint::color {

/// Target color as a range in HSI (Gonzalez & Woods). Hue is circular, in degrees [0, 360). If
/// hueMin > hueMax, the range contains hue 0. Saturation and intensity are in [0, 1]. All bounds
/// are inclusive.
struct ColorRange {
  double hueMin = 0.0;
  double hueMax = 0.0;
  double saturationMin = 0.0;
  double saturationMax = 1.0;
  double intensityMin = 0.0;
  double intensityMax = 1.0;

  bool operator==(const ColorRange&) const = default;
};

/// Returns whether the range spans every hue (0 to 360). Such a range ignores hue, so gray, which
/// has no hue, matches as well.
bool spansEveryHue(const ColorRange& range);

/// Maps any angle in degrees to the equivalent hue in [0, 360).
double normalizedHue(double angle);

/// Checks a range. Error: BadValue with the field "hue", "saturation" or "intensity" if a bound is
/// not finite or outside its limits, or if no color could ever match. A hue bound of 360 is
/// allowed, because 0 to 360 means every hue.
Status checkColorRange(const ColorRange& range);

} // namespace dewpoint::color
