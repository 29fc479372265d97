// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"
#include "core/color/color_ranges.h"
#include "core/color/hsi_counts.h"

#include <vector>

namespace dewpoint::color {

/// Measure of how well color ranges match the target colors but no other colors.
struct RangeScore {
  double targetWeight = 0.0; ///< weight of the matching target colors
  double restWeight = 0.0;   ///< weight of the matching other colors
  double f1 = 0.0; ///< F1 score, 0 to 1: 2 * targetWeight / (weight of all target colors +
                   ///< targetWeight + restWeight)
};
/// Returns the score of ranges for the colors of the target and the other colors (`rest`).
RangeScore scoreRange(const ColorRanges& ranges, const std::vector<WeightedHsiColor>& target,
                      const std::vector<WeightedHsiColor>& rest);

/// Fits the range with the highest F1 score by coordinate ascent. In each step, two of hue,
/// saturation and intensity are held fixed, and the best interval of the third is found exactly (on
/// whole degrees or hundredths). The steps are repeated until nothing improves. The ascent starts
/// from several boxes of quantiles of the target colors, and the best result is used. The weights
/// of both sets are in pixels. At least one target color must not be black.
ColorRange fitRange(const std::vector<WeightedHsiColor>& target,
                    const std::vector<WeightedHsiColor>& rest);

/// Returns the range with the narrowest hue interval among those with the same score as `range`.
/// Use it after fitRange(), which may choose an interval that spans a wide gap: a part of the hue
/// circle in which neither the target nor the rest has a color.
ColorRange withNarrowestHue(const ColorRange& range, const std::vector<WeightedHsiColor>& target,
                            const std::vector<WeightedHsiColor>& rest);

} // namespace dewpoint::color
