// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstddef>
#include <string>

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

/// Color of the i-th target, from the color-blind-safe set of Okabe and Ito (2008).
SceneColor targetColor(std::size_t index);
/// The same for targets of the project; persons have the color of their identity everywhere.
SceneColor targetColor(const std::string& name, std::size_t index);
/// Colors of the x, y and z axis, from the same set.
SceneColor axisColor(int axis);

/// Straight from `from` (at 0) to `to` (at 1).
inline SceneColor mix(const SceneColor& from, const SceneColor& to, double share) {
  return from + (to - from) * share;
}

} // namespace dewpoint::ui
