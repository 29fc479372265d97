// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"
#include "core/color/color_sample.h"
#include "core/color/hsi_counts.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::color {

struct ColorEvidence;

/// Maximum number of separate colors that samples give a target.
inline constexpr std::size_t kMostColorsOfTarget = 3;

/// Groups the samples that show the target by color: the indices of the samples of each color, in
/// the order of the first sample of each. Samples of one color in different light, or in a camera
/// of different white balance, stay together. If there are more than kMostColorsOfTarget colors,
/// the nearest ones are merged.
std::vector<std::vector<std::size_t>> colorsOfSamples(const std::vector<ColorSample>& samples);

/// Ranges for a target of several colors, at least two, in the order of
/// ColorEvidence::targetByColor. A color that is also common in the surroundings is left out.
/// Nothing if the samples show one color, or if `one` range for all of them separates about as
/// well.
std::optional<ColorRanges> severalRanges(const ColorEvidence& evidence, const ColorRange& one);

} // namespace dewpoint::color
