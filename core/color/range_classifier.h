// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"
#include "core/color/integer_line.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace dewpoint::color {

/// Answers "does this pixel match the target color" without trigonometry, tables or divisions, and
/// with the same answer as matches(hsiFromBgr(b, g, r), range).
///
/// The hue is the direction of the vector (2R - G - B, sqrt(3) (G - B)), so each hue bound is a
/// half-plane: a range up to 180 degrees wide is both half-planes, a wider one is either. Written
/// in differences of channels, a half-plane is an IntegerLine. The bounds of the saturation become
/// bounds on min(R,G,B) against what the sum exceeds 3 min by, lines again, and the intensity is
/// R + G + B.
class RangeClassifier {
public:
  /// `range` has passed checkColorRange().
  explicit RangeClassifier(const ColorRange& range);

  /// True if the pixel's color lies in the range. Black never matches, gray only where every hue
  /// does.
  bool matches(std::uint8_t b, std::uint8_t g, std::uint8_t r) const noexcept {
    const int sum = int(r) + g + b;
    if (sum < sumMin_ || sum > sumMax_) {
      return false;
    }
    const int least = std::min({r, g, b});
    const std::array<int, 2> leastAndExcess{least, sum - 3 * least};
    return leastBelow_.contains(leastAndExcess) && leastAbove_.contains(leastAndExcess) &&
           hueMatches({b, g, r});
  }

  /// The same for `count` pixels of three bytes (blue, green, red) side by side: 255 where the
  /// color matches, 0 elsewhere. `out` must not overlap the pixels.
  void matchRow(const std::uint8_t* bgr, std::int64_t count, std::uint8_t* out) const noexcept;

private:
  friend struct MatchRowKernel;

  /// How the two half-planes of the hue make a range.
  enum class HueRange { Both, Either, Every };

  /// A hue bound: the colors on its side have channel[yPlus] - channel[yMinus] above the line at
  /// x = channel[xPlus] - channel[xMinus]. Gray is on no side.
  struct HuePlane {
    std::size_t yPlus = 0, yMinus = 0, xPlus = 0, xMinus = 0; ///< 0 blue, 1 green, 2 red
    HueLine line;

    /// Where alongRed (2R - G - B) + alongGreenBlue (G - B) > 0.
    static HuePlane positive(double alongRed, double alongGreenBlue);
    bool contains(const std::array<int, 3>& bgr) const noexcept {
      return line.below(bgr[xPlus] - bgr[xMinus], bgr[yPlus] - bgr[yMinus]);
    }
  };

  /// A saturation bound: a line between the least channel (0) and the excess (1).
  struct RatioPlane {
    std::size_t y = 0, x = 0;
    RatioLine line{0, 0}; ///< every color is on the line y = 0, of scale 0
    bool above = false;   ///< the side where y is greater; else where it is not

    /// Where 3 min / sum is greater than `bound`, or where it is smaller.
    static RatioPlane beyond(double bound, bool greater);
    bool contains(const std::array<int, 2>& leastAndExcess) const noexcept {
      return line.below(leastAndExcess[x], leastAndExcess[y]) == above;
    }
  };

  bool hueMatches(const std::array<int, 3>& bgr) const noexcept {
    switch (hueRange_) {
    case HueRange::Both:
      return fromMin_.contains(bgr) && untilMax_.contains(bgr);
    case HueRange::Either:
      return fromMin_.contains(bgr) || untilMax_.contains(bgr);
    case HueRange::Every:
      break;
    }
    return true;
  }

  int sumMin_ = 1; ///< at least 1: black never matches
  int sumMax_ = 0;
  RatioPlane leastAbove_;
  RatioPlane leastBelow_;
  HuePlane fromMin_;
  HuePlane untilMax_;
  HueRange hueRange_ = HueRange::Both;
};

} // namespace dewpoint::color
