// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::session {

/// A color of the screen: sRGB red, green and blue, each 0 to 1.
using DisplayColor = Eigen::Vector3d;

/// What decides about the color that a target is drawn in.
struct DisplayColorWish {
  ColorRanges learned{};               ///< empty: the method knows targets by something else
  std::optional<DisplayColor> fixed{}; ///< is taken as it is: the identity of a person

  bool operator==(const DisplayColorWish&) const = default;
};

/// The middle of a learned range; nothing where that is gray or the range holds colors of many
/// kinds.
std::optional<DisplayColor> middleColor(const ColorRange& range);

/// The same hue, made darker or lighter until it reads on a light (or dark) ground.
DisplayColor legibleOn(const DisplayColor& color, bool darkGround);

/// Whether two colors cannot be told apart at a glance. Compared in OKLab (Ottosson 2020), with
/// lightness counted half.
bool areAlike(const DisplayColor& one, const DisplayColor& other);

/// One color for each target: the middle of the first range it was learned with, legible on the
/// ground. Targets that would look alike, and those without a clear color, have that of their index
/// in `palette` (not empty; used cyclically), or the next one that no other target has.
std::vector<DisplayColor> displayColors(const std::vector<DisplayColorWish>& wishes,
                                        const std::vector<DisplayColor>& palette, bool darkGround);

} // namespace dewpoint::session
