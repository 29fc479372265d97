// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"
#include "core/color/range_classifier.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace dewpoint::color {

/// Tests whether a pixel has the target's color, given by one or more ranges. The result equals
/// matches(hsiFromBgr(b, g, r), ranges).
class ColorClassifier {
public:
  /// Creates a classifier for at least one range. All ranges must have passed checkColorRange().
  explicit ColorClassifier(const ColorRanges& ranges);

  /// Returns whether the pixel's color lies in any of the ranges. Black never matches. Gray matches
  /// only ranges that span every hue.
  bool matches(std::uint8_t b, std::uint8_t g, std::uint8_t r) const noexcept {
    return first_.matches(b, g, r) ||
           std::ranges::any_of(
               others_, [&](const RangeClassifier& other) { return other.matches(b, g, r); });
  }

  /// Classifies `count` adjacent pixels of three bytes (blue, green, red). Writes 255 where the
  /// color matches, and 0 elsewhere. `out` must not overlap the pixels.
  void matchRow(const std::uint8_t* bgr, std::int64_t count, std::uint8_t* out) const noexcept;

private:
  /// First range, which for most targets is the only one; stored here to avoid a memory access
  /// through a pointer.
  RangeClassifier first_;
  std::vector<RangeClassifier> others_;
};

} // namespace dewpoint::color
