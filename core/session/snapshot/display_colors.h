// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::session {

/// Display color: sRGB red, green and blue, each 0 to 1.
using DisplayColor = Eigen::Vector3d;

/// What a target is drawn on.
enum class DisplayGround {
  Light, ///< light window
  Dark,  ///< dark window
  Image, ///< image of a camera, which may show the target itself: lighter than its learned color
};

/// Inputs that determine the display color of a target.
struct DisplayColorSource {
  ColorRanges learned{};               ///< empty: the method does not identify targets by color
  std::optional<DisplayColor> fixed{}; ///< color for a person's identity, used unchanged

  bool operator==(const DisplayColorSource&) const = default;
};

/// Returns the central color of a learned range; nothing if this color is gray, or if the range
/// contains many different colors.
std::optional<DisplayColor> centralColor(const ColorRange& range);

/// Returns a color of the same hue, darkened or lightened until it is legible on this ground.
DisplayColor legibleOn(const DisplayColor& color, DisplayGround ground);

/// Returns whether two colors are hard to distinguish. They are compared in OKLab (Ottosson 2020),
/// with half weight for lightness.
bool areSimilar(const DisplayColor& one, const DisplayColor& other);

/// Returns the colors for targets whose own colors are too similar or unclear: the color-blind-safe
/// set of Okabe and Ito (2008), in shades that are legible on this ground. An index has the same
/// hue on every ground.
const std::vector<DisplayColor>& displayPalette(DisplayGround ground);

/// Returns one color per target: the center of its first learned range, made legible on the ground.
/// Targets whose colors are too similar, and those without a clear color, get the color at their
/// index in `displayPalette()` (used cyclically), or the next one that no other target has. So do
/// all targets after the first `kMostOwnColors`. A target has the same hue on every ground.
std::vector<DisplayColor> displayColors(const std::vector<DisplayColorSource>& sources,
                                        DisplayGround ground);
/// Number of targets that can have the color they were learned with. More could not be
/// distinguished, and comparing all of them takes too long.
inline constexpr std::size_t kMostOwnColors = 100;

} // namespace dewpoint::session
