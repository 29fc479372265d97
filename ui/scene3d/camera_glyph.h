// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <string>

namespace dewpoint::ui {

/// A camera as it is drawn in the scene: the pyramid it looks through. World, meters.
struct CameraGlyph {
  std::string name;
  Eigen::Vector3d center;                 ///< the apex
  std::array<Eigen::Vector3d, 4> corners; ///< of the image, around from its upper left
  std::size_t camera = 0;                 ///< its index in the rig
};

} // namespace dewpoint::ui
