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

/// Background on which a target is drawn.
enum class DisplayBackground {
  Light, ///< light window
  Dark,  ///< dark window
  Image, ///< camera image; colors are lighter than the target, so that they stand out from it
};

/// Inputs that determine the display color of a target.
struct DisplayColorSource {
  /// Learned colors of the target; empty: the method does not identify targets by color.
  ColorRanges learnedColors{};
  std::optional<DisplayColor> fixedColor{}; ///< color for a person's identity, used unchanged

  bool operator==(const DisplayColorSource&) const = default;
};

/// Returns the color at the center of a learned range; nothing if this color is gray, or if the
/// range contains many different colors.
std::optional<DisplayColor> centralColor(const ColorRange& range);

/// Returns a color of the same hue, darkened or lightened until it is legible on this background.
DisplayColor legibleColor(const DisplayColor& color, DisplayBackground background);

/// Returns whether two colors are hard to distinguish. The colors are compared in the color space
/// OKLab (Ottosson 2020), with half weight for lightness.
bool areSimilar(const DisplayColor& one, const DisplayColor& other);

/// Returns the colors for targets whose own colors are too similar or unclear: the color-blind-safe
/// set of Okabe and Ito (2008), in shades that are legible on this background. An index has the
/// same hue on every background.
const std::vector<DisplayColor>& displayPalette(DisplayBackground background);

/// Returns one display color per target: the center of its first learned range, made legible on the
/// background. Some targets get the color at their index in `displayPalette()` (used cyclically)
/// instead, or the next one that no other target has: targets with similar colors, targets without
/// a clear color, and all targets after the first `kMaxOwnColors`. A target has the same hue on
/// every background.
std::vector<DisplayColor> displayColors(const std::vector<DisplayColorSource>& sources,
                                        DisplayBackground background);
/// Number of targets that can be displayed in their learned color. More could not be distinguished,
/// and comparing all of them would take too long.
inline constexpr std::size_t kMaxOwnColors = 100;

} // namespace dewpoint::session
