// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_range.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace dewpoint::color {
namespace {

/// False for NaN too.
bool within(double value, double low, double high) {
  return value >= low && value <= high;
}

Status refuse(const char* field, double low, double high, const char* rule) {
  return failure(ErrorCode::BadValue, {}, field, fmt::format("{} to {}: {}", low, high, rule));
}

Status checkFraction(const char* field, double low, double high) {
  if (!within(low, 0.0, 1.0) || !within(high, 0.0, 1.0)) {
    return refuse(field, low, high, "both bounds must be within 0 and 1");
  }
  if (low > high) {
    return refuse(field, low, high, "the lower bound is above the upper one");
  }
  return {};
}

} // namespace

bool spansEveryHue(const ColorRange& range) {
  return range.hueMax - range.hueMin >= 360.0;
}

double normalizedHue(double angle) {
  return angle - 360.0 * std::floor(angle / 360.0);
}

Status checkColorRange(const ColorRange& range) {
  if (!within(range.hueMin, 0.0, 360.0) || !within(range.hueMax, 0.0, 360.0)) {
    return refuse("hue", range.hueMin, range.hueMax, "both bounds must be within 0 and 360");
  }
  if (Status status = checkFraction("saturation", range.saturationMin, range.saturationMax);
      !status) {
    return status;
  }
  if (Status status = checkFraction("intensity", range.intensityMin, range.intensityMax); !status) {
    return status;
  }
  if (range.intensityMax == 0.0) {
    return refuse("intensity", range.intensityMin, range.intensityMax,
                  "the range contains only black, which never matches");
  }
  return {};
}

} // namespace dewpoint::color
