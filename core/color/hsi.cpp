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
  const double theta = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
  color.hueDegrees = b <= g ? theta : 360.0 - theta;
  return color;
}

bool matches(const Hsi& color, const ColorRange& range) {
  return color.intensity > 0.0 && hueWithin(color.hueDegrees, range) &&
         fractionWithin(color.saturation, range.saturationMin, range.saturationMax) &&
         fractionWithin(color.intensity, range.intensityMin, range.intensityMax);
}

} // namespace dewpoint::color
