// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>

namespace dewpoint::color {

/// The question "is y > slope * x?" for small integers x and y, answered by products of 16 bits:
///   scale * y > floor(factor * x / 65536).
/// Between two neighboring fractions y/x of the integers in question every slope gives the same
/// answers, and the fractions lie further apart than 1 / (65536 scale), so that one of the two
/// multiples of it beside the slope serves. (That the answers are the same is checked for every x
/// when the line is made.)
template <class Factor> struct IntegerLine {
  Factor factor = 0; ///< slope * scale * 65536, 16 bits
  std::uint16_t scale = 1;

  bool below(int x, int y) const noexcept { return scale * y > ((factor * x) >> 16); }
};

/// A line for |x|, |y| <= 255 and -1/2 <= slope <= 0, scale 1: neighboring fractions are at least
/// 1 / (255 * 254) apart. No integer point but 0 may lie on the line.
using HueLine = IntegerLine<std::int16_t>;
HueLine hueLine(double slope);

/// The two ways to write a ratio of two integers >= 0 with a slope below 1.
enum class RatioAxes {
  LeastPerExcess, ///< x <= 510, y <= (510 - x) / 2: the least channel against what exceeds it
  ExcessPerLeast, ///< x <= 255, y <= 510 - 2 x: the other way around
};

/// A line for 0 <= slope <= 1 and the integers that `axes` names; factor < 65536.
/// Neighboring fractions differ by (1 + 2 slope)^2 / 510^2 at least, or 1 / 255^2.
using RatioLine = IntegerLine<std::uint16_t>;
RatioLine ratioLine(double slope, RatioAxes axes);

} // namespace dewpoint::color
