// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::ui {

/// RGB color, 0 to 1 each.
using SceneColor = Eigen::Vector3d;

/// Returns the color given as 0xRRGGBB.
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

/// Returns the scene colors for a dark or a light window.
const ScenePalette& scenePalette(bool dark);

/// Returns the color of an axis: 0 is x, 1 is y, 2 is z.
SceneColor axisColor(int axis);

/// Interpolates linearly between `from` (fraction 0) and `to` (fraction 1).
inline SceneColor mix(const SceneColor& from, const SceneColor& to, double share) {
  return from + (to - from) * share;
}

} // namespace dewpoint::ui
