// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"
#include "core/color/color_ranges.h"

#include <array>
#include <cstdint>
#include <numbers>

namespace dewpoint::color {

/// Tolerance of an inclusive bound, in degrees for the hue and as a fraction for saturation and
/// intensity, so that rounding does not decide about colors that lie exactly on a bound. Far
/// smaller than the distance between any two 8-bit colors.
inline constexpr double kBoundSlack = 1e-10;

/// A color in the HSI model of Gonzalez & Woods, Digital Image Processing, section 6.2 (RGB to
/// HSI).
struct Hsi {
  double hueDegrees = 0.0; ///< [0, 360), 0 is red, 120 green; NaN for gray, which has no hue
  double saturation = 0.0; ///< [0, 1]; 0 for black
  double intensity = 0.0;  ///< [0, 1]
};

/// An angle of a hue, radians, in degrees. Not base::inDegrees(), which rounds otherwise and would
/// put colors that lie on a bound on its other side.
inline double hueDegreesOf(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

/// HSI of one 8-bit pixel, by the book's arc cosine. Exact but slow: the reference that
/// ColorClassifier is held to.
Hsi hsiFromBgr(std::uint8_t b, std::uint8_t g, std::uint8_t r);

/// Inverse of hsiFromBgr(): blue, green and red in gray levels, not rounded. Values above 255
/// belong to no 8-bit color.
std::array<double, 3> bgrFromHsi(const Hsi& color);

/// Returns true if the color lies in the range. Black never matches; gray matches only ranges that
/// span every hue.
bool matches(const Hsi& color, const ColorRange& range);
/// Returns true if the color lies in any of the ranges.
bool matches(const Hsi& color, const ColorRanges& ranges);

} // namespace dewpoint::color
