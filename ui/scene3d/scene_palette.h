// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::ui {

/// RGB, 0 to 1.
using SceneColor = Eigen::Vector3d;

/// The color of a number 0xRRGGBB.
SceneColor sceneColor(unsigned rgb);

/// The colors of the scene for a light or a dark window.
struct ScenePalette {
  SceneColor background;
  SceneColor floor;
  SceneColor gridMinor;
  SceneColor gridMajor;
  SceneColor text;
  SceneColor camera;
  SceneColor truth;
};

const ScenePalette& scenePalette(bool dark);

/// Colors of targets whose own color does not tell them apart, from the color-blind-safe set of
/// Okabe and Ito (2008).
const std::vector<SceneColor>& targetColors();
/// The i-th of them, again from the first on.
SceneColor targetColor(std::size_t index);
/// Persons have the color of their identity everywhere; nothing for the name of any other target.
std::optional<SceneColor> identityColorOf(const std::string& name);
/// Colors of the x, y and z axis, from the same set.
SceneColor axisColor(int axis);

/// Straight from `from` (at 0) to `to` (at 1).
inline SceneColor mix(const SceneColor& from, const SceneColor& to, double share) {
  return from + (to - from) * share;
}

} // namespace dewpoint::ui
