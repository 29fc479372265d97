// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <string>

namespace dewpoint::ui {

/// Viewing pyramid that represents a camera in the scene. World coordinates, meters.
struct CameraGlyph {
  std::string name;
  Eigen::Vector3d center; ///< apex
  /// Image corners in circular order, starting at the upper left.
  std::array<Eigen::Vector3d, 4> corners;
  std::size_t camera = 0; ///< index in the rig
};

} // namespace dewpoint::ui
