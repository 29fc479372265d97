// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"
#include "core/color/color_ranges.h"
#include "core/color/hsi_counts.h"

#include <vector>

namespace dewpoint::color {

/// How much of two sets of colors is matched by one or more ranges.
struct RangeScore {
  double target = 0.0; ///< weight of the matching target colors
  double rest = 0.0;   ///< weight of the other matching colors
  double f1 = 0.0;     ///< 2 target / (all of the target + target + rest)
};
/// Returns the score of ranges for the colors of the target and the other colors (`rest`).
RangeScore scoreRange(const ColorRanges& ranges, const std::vector<WeightedHsiColor>& target,
                      const std::vector<WeightedHsiColor>& rest);

/// Fits the range with the highest F1 score by coordinate ascent. With two of hue, saturation and
/// intensity held fixed, the best interval of the third is found exactly (on whole degrees and
/// hundredths). This is repeated in turn until nothing improves, starting from several quantile
/// boxes of the target colors. Weights are in pixels for both sets. The target needs at least one
/// color that is not black.
ColorRange fitRange(const std::vector<WeightedHsiColor>& target,
                    const std::vector<WeightedHsiColor>& rest);

/// Returns the range with the narrowest hue interval that has the same score. On the hue circle, at
/// least two intervals contain the same colors, one of which spans the widest gap between these
/// colors. fitRange() may choose that one if neither the target nor the rest has a hue in the gap.
ColorRange withNarrowestHue(const ColorRange& range, const std::vector<WeightedHsiColor>& target,
                            const std::vector<WeightedHsiColor>& rest);

} // namespace dewpoint::color
