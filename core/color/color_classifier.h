// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"

#include <algorithm>
#include <cstdint>

namespace dewpoint {

/// Answers "does this pixel match the target color" without trigonometry per pixel, and with the
/// same answer as matches(hsiFromBgr(b, g, r), range).
///
/// The hue is the direction of the vector (2R - G - B, sqrt(3) (G - B)), so each hue bound is a
/// half-plane: a range up to 180 degrees wide is both half-planes, a wider one is either. The
/// bounds of saturation and intensity become bounds on 3 min(R,G,B) and on R + G + B.
class ColorClassifier {
public:
  /// `range` has passed checkColorRange().
  explicit ColorClassifier(const ColorRange& range);

  /// True if the pixel's color lies in the range. Black never matches, gray only where every hue
  /// does.
  bool matches(std::uint8_t b, std::uint8_t g, std::uint8_t r) const noexcept {
    const int sum = int(r) + g + b;
    if (sum < sumMin_ || sum > sumMax_) {
      return false;
    }
    const double least = 3.0 * std::min({r, g, b});
    if (least > leastPerSumMax_ * sum || least < leastPerSumMin_ * sum) {
      return false;
    }
    return everyHue_ || hueMatches(2 * int(r) - g - b, int(g) - b);
  }

private:
  /// A hue bound as a line through the gray axis: positive on the side of the range.
  struct HalfPlane {
    double alongRed = 0.0;
    double alongGreenBlue = 0.0;
    bool contains(int red, int greenBlue) const noexcept {
      return alongRed * red + alongGreenBlue * greenBlue >= 0.0;
    }
  };

  bool hueMatches(int red, int greenBlue) const noexcept {
    const bool afterMin = fromMin_.contains(red, greenBlue);
    const bool beforeMax = untilMax_.contains(red, greenBlue);
    const bool inside = wide_ ? (afterMin || beforeMax) : (afterMin && beforeMax);
    return inside && (red != 0 || greenBlue != 0); // gray has no hue
  }

  int sumMin_ = 1; ///< at least 1: black never matches
  int sumMax_ = 0;
  double leastPerSumMin_ = 0.0;
  double leastPerSumMax_ = 0.0;
  HalfPlane fromMin_;
  HalfPlane untilMax_;
  bool wide_ = false;
  bool everyHue_ = false;
};

} // namespace dewpoint
