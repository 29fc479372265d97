// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <string>

namespace dewpoint::ui {

/// A camera as drawn in the scene: its viewing pyramid. World coordinates, meters.
struct CameraGlyph {
  std::string name;
  Eigen::Vector3d center; ///< apex
  /// corners of the image, going around from the upper left
  std::array<Eigen::Vector3d, 4> corners;
  std::size_t camera = 0; ///< index in the rig
};

} // namespace dewpoint::ui
