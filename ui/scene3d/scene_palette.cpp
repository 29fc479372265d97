// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/scene_palette.h"

#include <array>
#include <cstddef>

namespace dewpoint::ui {
SceneColor sceneColor(unsigned rgb) {
  return SceneColor((rgb >> 16U) & 255U, (rgb >> 8U) & 255U, rgb & 255U) / 255.0;
}

const ScenePalette& scenePalette(bool dark) {
  static const ScenePalette kLight{sceneColor(0xf4f5f7), sceneColor(0xffffff), sceneColor(0xe6e9ed),
                                   sceneColor(0xc6ccd4), sceneColor(0x4a5560), sceneColor(0x5b6672),
                                   sceneColor(0x111111)};
  static const ScenePalette kDark{sceneColor(0x1b1e23), sceneColor(0x22262c), sceneColor(0x2c3138),
                                  sceneColor(0x444c56), sceneColor(0xaeb6c0), sceneColor(0x9aa5b1),
                                  sceneColor(0xffffff)};
  return dark ? kDark : kLight;
}

SceneColor axisColor(int axis) {
  static const std::array<unsigned, 3> kColors{0xcc79a7, 0x009e73, 0x0072b2};
  return sceneColor(kColors[static_cast<std::size_t>(axis) % kColors.size()]);
}

} // namespace dewpoint::ui
