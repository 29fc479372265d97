// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/scene/rigs.h"

#include "core/geometry/camera_name.h"
#include "core/simulation/scene/scene.h"

#include <array>
#include <cmath>
#include <numbers>

namespace dewpoint::simulation {
namespace {

struct Picture {
  int width = 320;
  int height = 240;
  double focal = kDeskFocal; ///< pixels
};

Camera cameraAt(std::size_t index, const Picture& picture, const Eigen::Vector3d& position,
                const Eigen::Vector3d& target) {
  Camera camera;
  camera.name = defaultCameraName(index);
  camera.intrinsics = {picture.width,
                       picture.height,
                       picture.focal,
                       picture.focal,
                       (picture.width - 1) / 2.0,
                       (picture.height - 1) / 2.0};
  camera.cameraFromWorld = lookAt(position, target);
  return camera;
}

} // namespace

CameraRig threeCameraDeskRig() {
  CameraRig rig = demoRig();
  rig.push_back(cameraAt(rig.size(), {}, {0.95, 0.05, 0.5}, kDeskCenter));
  return rig;
}

CameraRig deskRingRig(int count) {
  // Eighths of a turn; two cameras see the volume at right angles, four from all sides.
  static constexpr std::array<int, 8> kSlots{0, 2, 4, 6, 1, 3, 5, 7};
  constexpr double kDistance = 1.1; // meters from the middle; chosen: inside the room's walls
  CameraRig rig;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const int slot = kSlots.at(i);
    const double angle = -0.4 + 0.25 * std::numbers::pi * slot;
    const double height = slot % 2 == 0 ? 0.45 : 0.6; // above the middle, meters
    const double reach = std::sqrt(kDistance * kDistance - height * height);
    const Eigen::Vector3d offset{reach * std::cos(angle), reach * std::sin(angle), height};
    rig.push_back(cameraAt(i, {}, kDeskCenter + offset, kDeskCenter));
  }
  return rig;
}

CameraRig hallRig(int count) {
  // World x and y, meters: 0.15 m inside the corners.
  static constexpr std::array<std::array<double, 2>, 4> kCorners{
      {{-2.1, -2.1}, {2.1, -2.1}, {-2.1, 2.1}, {2.1, 2.1}}};
  CameraRig rig;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const auto& corner = kCorners.at(i);
    rig.push_back(cameraAt(i, {640, 480, 400.0}, {corner[0], corner[1], 1.9}, {0.0, 0.0, 0.9}));
  }
  return rig;
}

} // namespace dewpoint::simulation
