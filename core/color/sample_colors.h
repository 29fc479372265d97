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

/// Maximum number of separate colors of a target that are learned from samples.
inline constexpr std::size_t kMaxTargetColors = 3;

/// Groups the samples that show the target by color. Returns the sample indices for each color, in
/// the order of each color's first sample. Samples of one color in different light, or in cameras
/// with different white balance, stay together. If there are more than kMaxTargetColors colors,
/// the most similar colors are merged.
std::vector<std::vector<std::size_t>> groupSamplesByColor(const std::vector<ColorSample>& samples);

/// Returns at least two ranges for a multicolored target, in the order of the separate colors of
/// the samples (ColorEvidence::targetColorsBySampleColor). A color that is also common in the
/// surroundings is left out. Returns nothing if the samples show one color, or if the single range
/// `one` separates all samples from the rest about as well.
std::optional<ColorRanges> multicolorRanges(const ColorEvidence& evidence, const ColorRange& one);

} // namespace dewpoint::color
