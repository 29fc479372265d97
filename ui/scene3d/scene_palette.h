// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::ui {

/// RGB, 0 to 1 each.
using SceneColor = Eigen::Vector3d;

/// Returns the color 0xRRGGBB.
SceneColor sceneColor(unsigned rgb);

/// Colors of the scene for a light or a dark window.
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

/// Colors in the scene of targets whose own color does not tell them apart, from the
/// color-blind-safe set of Okabe and Ito (2008). Not those of targetColor() (ui/style): the ground
/// of the scene is light or dark with the window, strokes over images need lighter colors.
const std::vector<SceneColor>& sceneTargetColors();
/// The i-th of them, again from the first on.
SceneColor sceneTargetColor(std::size_t index);
/// Persons have the color of their identity everywhere; nothing for the name of any other target.
std::optional<SceneColor> identityColorOf(const std::string& name);
/// Color of the x, y or z axis, from the same set.
SceneColor axisColor(int axis);

/// Interpolates linearly between `from` (share 0) and `to` (share 1).
inline SceneColor mix(const SceneColor& from, const SceneColor& to, double share) {
  return from + (to - from) * share;
}

} // namespace dewpoint::ui
