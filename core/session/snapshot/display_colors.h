// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::session {

/// Display color: sRGB red, green and blue, each 0 to 1.
using DisplayColor = Eigen::Vector3d;

/// Inputs that determine the display color of a target.
struct DisplayColorSource {
  ColorRanges learned{};               ///< empty: the method does not identify targets by color
  std::optional<DisplayColor> fixed{}; ///< color for a person's identity, used unchanged

  bool operator==(const DisplayColorSource&) const = default;
};

/// Returns the central color of a learned range; nothing if this color is gray, or if the range
/// contains many different colors.
std::optional<DisplayColor> centralColor(const ColorRange& range);

/// Returns a color of the same hue, darkened or lightened until it is legible on a light or dark
/// background.
DisplayColor legibleOn(const DisplayColor& color, bool darkBackground);

/// Returns whether two colors are hard to distinguish. They are compared in OKLab (Ottosson 2020),
/// with half weight for lightness.
bool areSimilar(const DisplayColor& one, const DisplayColor& other);

/// Returns one color per target: the center of its first learned range, made legible on the
/// background. Targets whose colors are too similar, and those without a clear color, get the color
/// at their index in `palette` (not empty; used cyclically), or the next one that no other target
/// has.
std::vector<DisplayColor> displayColors(const std::vector<DisplayColorSource>& sources,
                                        const std::vector<DisplayColor>& palette,
                                        bool darkBackground);

} // namespace dewpoint::session
