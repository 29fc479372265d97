// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::ui {

/// RGB color, 0 to 1 each.
using SceneColor = Eigen::Vector3d;

/// Returns the color for 0xRRGGBB.
SceneColor sceneColor(unsigned rgb);

/// Scene colors for a light or a dark window.
struct ScenePalette {
  SceneColor background;
  SceneColor floor;
  SceneColor gridMinor;
  SceneColor gridMajor;
  SceneColor text;
  SceneColor camera;
  SceneColor truth;
};

/// Returns the colors for a dark or a light window.
const ScenePalette& scenePalette(bool dark);

/// Returns the scene colors for targets whose own colors are too similar or unclear, from the
/// color-blind-safe set of Okabe and Ito (2008). They differ from targetColor() (ui/style), because
/// the scene background is light or dark like the window, whereas lines over images need lighter
/// colors.
const std::vector<SceneColor>& sceneTargetColors();
/// Returns the color with this index in `sceneTargetColors()`, starting again after the last one.
SceneColor sceneTargetColor(std::size_t index);
/// Returns the identity color of a person, which is the same in all views, or nothing if `name` is
/// the name of another kind of target.
std::optional<SceneColor> identityColorOf(const std::string& name);
/// Returns the color of the x, y or z axis, from the same set.
SceneColor axisColor(int axis);

/// Interpolates linearly between `from` (fraction 0) and `to` (fraction 1).
inline SceneColor mix(const SceneColor& from, const SceneColor& to, double share) {
  return from + (to - from) * share;
}

} // namespace dewpoint::ui
