// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_classifier.h"

#include "core/color/hsi.h"

#include <cmath>
#include <numbers>

namespace dewpoint {
namespace {

constexpr double kSumOfWhite = 3.0 * 255.0;

} // namespace

ColorClassifier::ColorClassifier(const ColorRange& range)
    : sumMin_(std::max(1, int(std::ceil((range.intensityMin - kBoundSlack) * kSumOfWhite)))),
      sumMax_(int(std::floor((range.intensityMax + kBoundSlack) * kSumOfWhite))),
      // S = 1 - 3 min / sum, so the upper bound of S is the lower one of 3 min / sum.
      leastPerSumMin_(1.0 - range.saturationMax - kBoundSlack),
      leastPerSumMax_(1.0 - range.saturationMin + kBoundSlack) {
  // Widening both ends by the slack also keeps a range of a single hue from being a whole line,
  // which would take in the opposite hue.
  const double width = std::fmod(range.hueMax - range.hueMin + 720.0, 360.0) + 2.0 * kBoundSlack;
  everyHue_ = spansEveryHue(range);
  wide_ = width > 180.0;
  const double degree = std::numbers::pi / 180.0;
  const double low = (range.hueMin - kBoundSlack) * degree;
  const double high = (range.hueMax + kBoundSlack) * degree;
  fromMin_ = {-std::sin(low), std::numbers::sqrt3 * std::cos(low)};
  untilMax_ = {std::sin(high), -std::numbers::sqrt3 * std::cos(high)};
}

} // namespace dewpoint
