// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"
#include "core/color/integer_line.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace dewpoint::color {

/// Tests whether a pixel matches a color range, without trigonometry, tables or divisions. The
/// result equals matches(hsiFromBgr(b, g, r), range).
///
/// The hue is the direction of the vector (2R - G - B, sqrt(3) (G - B)), so each hue bound is a
/// half-plane. A range of up to 180 degrees is the intersection of the two half-planes; a wider
/// range is their union. Each half-plane is tested as an IntegerLine between two channel
/// differences. Each saturation bound is tested as an IntegerLine between min(R, G, B) and R + G +
/// B - 3 min(R, G, B). The intensity bounds are tested as bounds on R + G + B.
class RangeClassifier {
public:
  /// Creates a classifier for a range, which must have passed checkColorRange().
  explicit RangeClassifier(const ColorRange& range);

  /// Returns whether the pixel's color lies in the range. Black never matches. Gray matches only a
  /// range that spans every hue.
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

  /// Classifies `count` adjacent pixels of three bytes (blue, green, red). Writes 255 where the
  /// color matches, and 0 elsewhere. `out` must not overlap the pixels.
  void matchRow(const std::uint8_t* bgr, std::int64_t count, std::uint8_t* out) const noexcept;

private:
  friend struct MatchRowKernel;

  /// How the two hue half-planes are combined.
  enum class HueCombination { Both, Either, Every };

  /// Hue bound as a half-plane. A color is in the half-plane if y = channel[yPlus] -
  /// channel[yMinus] is above the line at x = channel[xPlus] - channel[xMinus]. Gray is never in
  /// the half-plane.
  struct HuePlane {
    std::size_t yPlus = 0, yMinus = 0, xPlus = 0, xMinus = 0; ///< 0 blue, 1 green, 2 red
    HueLine line;

    /// Returns the half-plane where alongRed (2R - G - B) + alongGreenBlue (G - B) > 0.
    static HuePlane fromCoefficients(double alongRed, double alongGreenBlue);
    bool contains(const std::array<int, 3>& bgr) const noexcept {
      return line.isBelow(bgr[xPlus] - bgr[xMinus], bgr[yPlus] - bgr[yMinus]);
    }
  };

  /// Saturation bound as a half-plane, whose border is a line. The coordinates of a color are its
  /// least channel, which is the smallest of blue, green and red (index 0), and its excess, which
  /// is the sum of the channels minus three times the least channel (index 1).
  struct RatioPlane {
    std::size_t y = 0, x = 0;
    /// Border of the half-plane; by default, every color is in the half-plane.
    RatioLine line{0, 0};
    /// True: the half-plane is the side of the line with greater y; false: the other side.
    bool isAbove = false;

    /// Returns the half-plane of the colors for which 3 min(R, G, B) / (R + G + B) is greater than
    /// `bound` if `greater` is true, otherwise smaller.
    static RatioPlane fromBound(double bound, bool greater);
    bool contains(const std::array<int, 2>& leastAndExcess) const noexcept {
      return line.isBelow(leastAndExcess[x], leastAndExcess[y]) == isAbove;
    }
  };

  bool hueMatches(const std::array<int, 3>& bgr) const noexcept {
    switch (hueRange_) {
    case HueCombination::Both:
      return fromMin_.contains(bgr) && untilMax_.contains(bgr);
    case HueCombination::Either:
      return fromMin_.contains(bgr) || untilMax_.contains(bgr);
    case HueCombination::Every:
      break;
    }
    return true;
  }

  /// Smallest matching sum of the channels; at least 1, so that black never matches.
  int sumMin_ = 1;
  int sumMax_ = 0;
  RatioPlane leastAbove_;
  RatioPlane leastBelow_;
  HuePlane fromMin_;
  HuePlane untilMax_;
  HueCombination hueRange_ = HueCombination::Both;
};

} // namespace dewpoint::color
