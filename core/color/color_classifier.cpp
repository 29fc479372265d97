// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_classifier.h"

#include "core/color/hsi.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace dewpoint::color {
namespace {

constexpr double kSumOfWhite = 3.0 * 255.0;

} // namespace

ColorClassifier::ColorClassifier(const ColorRange& range)
    : sumMin_(std::max(1, int(std::ceil((range.intensityMin - kBoundSlack) * kSumOfWhite)))),
      sumMax_(int(std::floor((range.intensityMax + kBoundSlack) * kSumOfWhite))),
      // S = 1 - 3 min / sum, so the upper bound of S is the lower one of 3 min / sum.
      leastAbove_(RatioPlane::beyond(1.0 - range.saturationMax - kBoundSlack, true)),
      leastBelow_(RatioPlane::beyond(1.0 - range.saturationMin + kBoundSlack, false)) {
  // Widening both ends by the slack keeps all colors off the lines, and a range of a single hue
  // from being a whole line, which would take in the opposite hue.
  const double width = std::fmod(range.hueMax - range.hueMin + 720.0, 360.0) + 2.0 * kBoundSlack;
  hueRange_ = spansEveryHue(range) ? HueRange::Every
              : width > 180.0      ? HueRange::Either
                                   : HueRange::Both;
  const double degree = std::numbers::pi / 180.0;
  const double low = (range.hueMin - kBoundSlack) * degree;
  const double high = (range.hueMax + kBoundSlack) * degree;
  fromMin_ = HuePlane::positive(-std::sin(low), std::numbers::sqrt3 * std::cos(low));
  untilMax_ = HuePlane::positive(std::sin(high), -std::numbers::sqrt3 * std::cos(high));
}

ColorClassifier::HuePlane ColorClassifier::HuePlane::positive(double alongRed,
                                                              double alongGreenBlue) {
  // The coefficients of B, G and R sum to zero, so each channel can be measured from a third one.
  // Measured from the middle coefficient's, the smallest is at most half the largest.
  const std::array<double, 3> coefficient{-alongRed - alongGreenBlue, -alongRed + alongGreenBlue,
                                          2.0 * alongRed};
  std::array<std::size_t, 3> channel{0, 1, 2};
  std::sort(channel.begin(), channel.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(coefficient[a]) < std::abs(coefficient[b]);
  });
  const auto [smallest, middle, largest] = channel;
  HuePlane plane{largest, middle, smallest, middle, {}};
  double slope = -coefficient[smallest] / std::abs(coefficient[largest]);
  if (coefficient[largest] < 0.0) {
    std::swap(plane.yPlus, plane.yMinus);
  }
  if (slope > 0.0) {
    std::swap(plane.xPlus, plane.xMinus);
    slope = -slope;
  }
  plane.line = hueLine(slope);
  return plane;
}

ColorClassifier::RatioPlane ColorClassifier::RatioPlane::beyond(double bound, bool greater) {
  if (greater ? bound <= 0.0 : bound >= 1.0) {
    return {}; // no bound at all
  }
  // 3 min > bound * sum with sum = 3 min + excess: min > slope * excess.
  const double slope = bound / (3.0 * (1.0 - bound));
  if (slope < 1.0) {
    return {0, 1, ratioLine(slope, RatioAxes::LeastPerExcess), greater};
  }
  return {1, 0, ratioLine(1.0 / slope, RatioAxes::ExcessPerLeast), !greater};
}

} // namespace dewpoint::color
