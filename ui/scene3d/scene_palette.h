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

/// Colors for targets whose own colors cannot be distinguished, from the color-blind-safe set of
/// Okabe and Ito (2008).
const std::vector<SceneColor>& targetColors();
/// Returns color number `index` of that set, starting over after the last one.
SceneColor targetColor(std::size_t index);
/// Returns the color of a person's identity, which is the same in all views; nothing for the name
/// of any other target.
std::optional<SceneColor> identityColorOf(const std::string& name);
/// Color of the x, y or z axis, from the same set.
SceneColor axisColor(int axis);

/// Interpolates linearly between `from` (share 0) and `to` (share 1).
inline SceneColor mix(const SceneColor& from, const SceneColor& to, double share) {
  return from + (to - from) * share;
}

} // namespace dewpoint::ui
