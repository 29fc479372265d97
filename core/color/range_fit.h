// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"
#include "core/color/color_ranges.h"
#include "core/color/hsi_counts.h"

#include <vector>

namespace dewpoint::color {

/// How much of two sets of colors a range takes in, or several together.
struct RangeScore {
  double target = 0.0; ///< weight of the target's colors that match
  double rest = 0.0;   ///< weight of the other colors that match
  double f1 = 0.0;     ///< 2 target / (all of the target + target + rest)
};
RangeScore scoreRange(const ColorRanges& ranges, const std::vector<HsiColors>& target,
                      const std::vector<HsiColors>& rest);

/// The range with the greatest F1 score, by coordinate ascent: with two of hue, saturation and
/// intensity kept, the best interval of the third is found exactly (on whole degrees and
/// hundredths), in turn, until nothing improves; from several quantile boxes of the target's
/// colors. Weights are pixels on both sides. At least one color of the target that is not black.
ColorRange fitRange(const std::vector<HsiColors>& target, const std::vector<HsiColors>& rest);

/// The range with the fewest hues of the same score. Around the circle the same colors lie in two
/// intervals at least, one of them across the widest gap between them: fitRange() may take that one
/// where neither the target nor the rest has such a hue.
ColorRange withShortestHue(const ColorRange& range, const std::vector<HsiColors>& target,
                           const std::vector<HsiColors>& rest);

} // namespace dewpoint::color
