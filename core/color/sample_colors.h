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

/// The most colors that a target is given by its samples.
inline constexpr std::size_t kMostColorsOfTarget = 3;

/// The samples that show the target, divided into the colors that they show: the indices of each
/// color's samples, in the order of its first one. Samples of one color in another light, or in a
/// camera of another white balance, stay together. Of more colors than kMostColorsOfTarget those
/// that are nearest count as one.
std::vector<std::vector<std::size_t>> colorsOfSamples(const std::vector<ColorSample>& samples);

/// Ranges for a target of several colors, at least two, in the order of
/// ColorEvidence::targetByColor. A color that everything around has too is left out. Nothing where
/// the samples show one color, or where `one` range for all of them separates about as well.
std::optional<ColorRanges> severalRanges(const ColorEvidence& evidence, const ColorRange& one);

} // namespace dewpoint::color
