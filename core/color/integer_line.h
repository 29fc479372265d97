// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>

namespace dewpoint::color {

/// Answers "is y > slope * x?" for small integers x and y with 16-bit products:
///   scale * y > floor(factor * x / 65536).
/// All slopes between two neighboring fractions y/x of these integers give the same answers. The
/// fractions are more than 1 / (65536 scale) apart, so one of the two multiples of that step next
/// to the slope can replace it. (When the line is made, the answers are checked to be the same for
/// every x.)
template <class Factor> struct IntegerLine {
  Factor factor = 0; ///< slope * scale * 65536, 16 bits
  std::uint16_t scale = 1;

  bool below(int x, int y) const noexcept { return scale * y > ((factor * x) >> 16); }
};

/// Line for |x|, |y| <= 255 and -1/2 <= slope <= 0, with scale 1: neighboring fractions are at
/// least 1 / (255 * 254) apart. No integer point except 0 may lie on the line.
using HueLine = IntegerLine<std::int16_t>;
HueLine hueLine(double slope);

/// Two ways to express a ratio of two integers >= 0 with a slope below 1.
enum class RatioAxes {
  LeastPerExcess, ///< x <= 510, y <= (510 - x) / 2: the least channel against what exceeds it
  ExcessPerLeast, ///< x <= 255, y <= 510 - 2 x: the other way around
};

/// Line for 0 <= slope <= 1 and the integers that `axes` names; factor < 65536. Neighboring
/// fractions differ by at least (1 + 2 slope)^2 / 510^2, or 1 / 255^2.
using RatioLine = IntegerLine<std::uint16_t>;
RatioLine ratioLine(double slope, RatioAxes axes);

} // namespace dewpoint::color
