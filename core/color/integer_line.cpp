// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/integer_line.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace dewpoint::color {
namespace {

constexpr int kMaxScale = 64; // 64 * 255 fits into 15 bits
constexpr double kOne = 65536.0;

/// Integers x of a line with the largest y that occurs there.
struct Domain {
  int xMin;
  int xMax;
  int yMaxAtZero;
  double yMaxSlope;

  int yMax(int x) const { return static_cast<int>(yMaxAtZero + yMaxSlope * x); }
};

/// True if the line separates the integers of the domain as the slope does: the largest y that is
/// not below must be the same at every x.
template <class Coefficient>
bool separates(const IntegerLine<Coefficient>& line, double slope, const Domain& domain) {
  for (int x = domain.xMin; x <= domain.xMax; ++x) {
    const int most = domain.yMax(x);
    const int wanted = static_cast<int>(std::floor(slope * x));
    const int have =
        static_cast<int>(std::floor(double((line.scaledSlope * x) >> 16) / double(line.scale)));
    if (std::min(wanted, most) != std::min(have, most)) {
      return false;
    }
  }
  return true;
}

template <class Coefficient>
IntegerLine<Coefficient> findLine(double slope, int maxScale, const Domain& domain) {
  for (int scale = maxScale; scale >= 1; --scale) {
    const int nearest = static_cast<int>(std::floor(slope * scale * kOne));
    for (const int factor : {nearest, nearest + 1}) {
      const IntegerLine<Coefficient> line{static_cast<Coefficient>(factor),
                                          static_cast<std::uint16_t>(scale)};
      if (line.scaledSlope == factor && separates(line, slope, domain)) {
        return line;
      }
    }
  }
  assert(false && "no line of 16 bits separates these integers");
  return {};
}

} // namespace

HueLine hueLine(double slope) {
  return findLine<std::int16_t>(slope, 1, {-255, 255, 255, 0.0});
}

RatioLine ratioLine(double slope, RatioAxes axes) {
  const int maxScale =
      slope * kMaxScale < 1.0 ? kMaxScale : std::max(1, static_cast<int>(1.0 / slope));
  return axes == RatioAxes::LeastPerExcess
             ? findLine<std::uint16_t>(slope, maxScale, {0, 510, 255, -0.5})
             : findLine<std::uint16_t>(slope, maxScale, {0, 255, 510, -2.0});
}

} // namespace dewpoint::color
