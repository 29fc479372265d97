// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"
#include "core/color/range_classifier.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace dewpoint::color {

/// Answers "does this pixel have the target's color", of one range or several, with the same answer
/// as matches(hsiFromBgr(b, g, r), ranges).
class ColorClassifier {
public:
  /// At least one range; all have passed checkColorRange().
  explicit ColorClassifier(const ColorRanges& ranges);

  /// True if the pixel's color lies in any of the ranges. Black never matches, gray only where
  /// every hue does.
  bool matches(std::uint8_t b, std::uint8_t g, std::uint8_t r) const noexcept {
    return first_.matches(b, g, r) ||
           std::ranges::any_of(
               others_, [&](const RangeClassifier& other) { return other.matches(b, g, r); });
  }

  /// The same for `count` pixels of three bytes (blue, green, red) side by side: 255 where the
  /// color matches, 0 elsewhere. `out` must not overlap the pixels.
  void matchRow(const std::uint8_t* bgr, std::int64_t count, std::uint8_t* out) const noexcept;

private:
  RangeClassifier first_; ///< the only one of most targets: no memory to follow
  std::vector<RangeClassifier> others_;
};

} // namespace dewpoint::color
