// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/hsi.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dewpoint::color {
namespace {

bool hueWithin(double hue, const ColorRange& range) {
  if (spansEveryHue(range)) {
    return true;
  }
  if (std::isnan(hue)) {
    return false;
  }
  const double width = std::fmod(range.hueMax - range.hueMin + 720.0, 360.0);
  // Measured from just below the lower bound, so that the slack wraps through 0 as well.
  const double beyond = std::fmod(hue - range.hueMin + kBoundSlack + 720.0, 360.0);
  return beyond <= width + 2.0 * kBoundSlack;
}

bool fractionWithin(double value, double low, double high) {
  return value >= low - kBoundSlack && value <= high + kBoundSlack;
}

} // namespace

Hsi hsiFromBgr(std::uint8_t b, std::uint8_t g, std::uint8_t r) {
  const double sum = double(r) + g + b;
  Hsi color;
  color.intensity = sum / (3.0 * 255.0);
  color.saturation = sum > 0.0 ? 1.0 - 3.0 * std::min({r, g, b}) / sum : 0.0;
  if (r == g && g == b) {
    color.hueDegrees = std::numeric_limits<double>::quiet_NaN();
    return color;
  }
  const double redGreen = double(r) - g;
  const double redBlue = double(r) - b;
  const double cosine =
      0.5 * (redGreen + redBlue) / std::sqrt(redGreen * redGreen + redBlue * (double(g) - b));
  const double theta = radiansToHueDegrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
  color.hueDegrees = b <= g ? theta : 360.0 - theta;
  return color;
}

std::array<double, 3> bgrFromHsi(const Hsi& color) {
  const double gray = 255.0 * color.intensity;
  if (std::isnan(color.hueDegrees)) {
    return {gray, gray, gray};
  }
  // The direction away from gray in which (2R - G - B, sqrt(3) (G - B)) has the hue's angle, and
  // then as far as the least channel says: S = 1 - min / I.
  const double angle = color.hueDegrees * std::numbers::pi / 180.0;
  const double alongRed = std::cos(angle) / 3.0;
  const double alongGreenBlue = std::sin(angle) / (2.0 * std::numbers::sqrt3);
  const std::array<double, 3> away{-0.5 * alongRed - alongGreenBlue,
                                   -0.5 * alongRed + alongGreenBlue, alongRed};
  const double distance = -gray * color.saturation / std::min({away[0], away[1], away[2]});
  return {gray + distance * away[0], gray + distance * away[1], gray + distance * away[2]};
}

bool matches(const Hsi& color, const ColorRange& range) {
  return color.intensity > 0.0 && hueWithin(color.hueDegrees, range) &&
         fractionWithin(color.saturation, range.saturationMin, range.saturationMax) &&
         fractionWithin(color.intensity, range.intensityMin, range.intensityMax);
}

bool matches(const Hsi& color, const ColorRanges& ranges) {
  return std::ranges::any_of(ranges, [&](const ColorRange& one) { return matches(color, one); });
}

} // namespace dewpoint::color
