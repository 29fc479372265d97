// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>

namespace dewpoint::color {

/// Tests whether y > slope * x for small integers x and y, using 16-bit products:
///   scale * y > floor(scaledSlope * x / 65536).
/// All slopes between two neighboring fractions y / x of these integers give the same results.
/// Neighboring fractions differ by more than the step 1 / (65536 * scale). The slope can therefore
/// be replaced with one of the two nearest multiples of this step. When a line is created, a check
/// makes sure that the results are the same for every x.
template <class Coefficient> struct IntegerLine {
  Coefficient scaledSlope = 0; ///< slope * scale * 65536, 16 bits
  std::uint16_t scale = 1;

  /// Returns whether y > slope * x, that is, whether the line is below the point (x, y).
  bool isBelow(int x, int y) const noexcept { return scale * y > ((scaledSlope * x) >> 16); }
};

/// Line that tests a hue bound, for |x|, |y| <= 255 and -1/2 <= slope <= 0; IntegerLine::scale is
/// 1. Neighboring fractions y / x are at least 1 / (255 * 254) apart. No integer point except the
/// origin may lie on the line.
using HueLine = IntegerLine<std::int16_t>;
/// Creates the line y = slope * x that tests a hue bound.
HueLine hueLine(double slope);

/// Two ways to express a bound on the ratio of two integers >= 0 as a line with a slope below 1.
/// The integers are the least channel, which is the smallest of blue, green and red, and the
/// excess, which is the sum of the channels minus three times the least channel.
enum class RatioAxes {
  LeastPerExcess, ///< x: excess, y: least channel; x <= 510, y <= (510 - x) / 2
  ExcessPerLeast, ///< x: least channel, y: excess; x <= 255, y <= 510 - 2 x
};

/// Line that tests a saturation bound, for 0 <= slope <= 1; RatioAxes specifies the integers x and
/// y. IntegerLine::scaledSlope is below 65536. Neighboring fractions y / x differ by at least (1 +
/// 2 slope)^2 / 510^2 with LeastPerExcess, and by at least 1 / 255^2 with ExcessPerLeast.
using RatioLine = IntegerLine<std::uint16_t>;
/// Creates the line y = slope * x that tests a saturation bound. `axes` specifies x and y.
RatioLine ratioLine(double slope, RatioAxes axes);

} // namespace dewpoint::color
