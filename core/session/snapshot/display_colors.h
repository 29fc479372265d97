// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::session {

/// Display color: sRGB red, green and blue, each 0 to 1.
using DisplayColor = Eigen::Vector3d;

/// What decides about the color that a target is drawn in.
struct DisplayColorSource {
  ColorRanges learned{};               ///< empty: the method knows targets by something else
  std::optional<DisplayColor> fixed{}; ///< is taken as it is: the identity of a person

  bool operator==(const DisplayColorSource&) const = default;
};

/// Returns the central color of a learned range; nothing if that is gray or the range contains many
/// different colors.
std::optional<DisplayColor> middleColor(const ColorRange& range);

/// Returns a color of the same hue, darkened or lightened until it is legible on a light or dark
/// background.
DisplayColor legibleOn(const DisplayColor& color, bool darkGround);

/// Returns whether two colors are hard to distinguish. They are compared in OKLab (Ottosson 2020),
/// with half weight for lightness.
bool areAlike(const DisplayColor& one, const DisplayColor& other);

/// One color for each target: the center of the first range it was learned with, legible on the
/// ground. Targets that would look alike, and those without a clear color, have that of their index
/// in `palette` (not empty; used cyclically), or the next one that no other target has.
std::vector<DisplayColor> displayColors(const std::vector<DisplayColorSource>& sources,
                                        const std::vector<DisplayColor>& palette, bool darkGround);

} // namespace dewpoint::session
