// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"
#include "core/color/color_ranges.h"

#include <array>
#include <cstdint>
#include <numbers>

namespace dewpoint::color {

/// Tolerance of the inclusive bounds of a color range, in degrees for hue and as a fraction for
/// saturation and intensity. With this tolerance, a color exactly on a bound always matches,
/// regardless of rounding. The tolerance is much smaller than the distance between any two 8-bit
/// colors.
inline constexpr double kBoundSlack = 1e-10;

/// Color in the HSI model of Gonzalez & Woods, Digital Image Processing, section 6.2 (RGB to HSI).
struct Hsi {
  double hueDegrees = 0.0; ///< [0, 360), 0 is red, 120 green; NaN for gray, which has no hue
  double saturation = 0.0; ///< [0, 1]; 0 for black
  double intensity = 0.0;  ///< [0, 1]
};

/// Converts a hue angle from radians to degrees. Do not use base::inDegrees() for hues: it rounds
/// differently, so a color that lies exactly on a bound would move to the other side of the bound.
inline double radiansToHueDegrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

/// Returns the HSI color of an 8-bit pixel, computed with the arc cosine formula of Gonzalez &
/// Woods. The function is exact but slow. It is the reference for testing ColorClassifier.
Hsi hsiFromBgr(std::uint8_t b, std::uint8_t g, std::uint8_t r);

/// Returns blue, green and red of an HSI color in gray levels, not rounded. This is the inverse of
/// hsiFromBgr(). If a value is above 255, no 8-bit color corresponds to `color`.
std::array<double, 3> bgrFromHsi(const Hsi& color);

/// Returns whether the color lies in the range. Black never matches. Gray matches only ranges that
/// span every hue.
bool matches(const Hsi& color, const ColorRange& range);
/// Returns whether the color lies in any of the ranges.
bool matches(const Hsi& color, const ColorRanges& ranges);

} // namespace dewpoint::color
