// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/room/view_cache.h"

#include <fmt/format.h>

namespace dewpoint::simulation {
namespace {

/// Everything that decides the view, with all digits ({} prints what reads back exactly).
std::string keyOf(const Camera& camera, Furnishing furnishing) {
  const Intrinsics& k = camera.intrinsics;
  std::string key = fmt::format("{} {} {} {} {} {} {}", static_cast<int>(furnishing), k.width,
                                k.height, k.focalX, k.focalY, k.centerX, k.centerY);
  key += fmt::format(" {}", static_cast<int>(camera.lens));
  for (const double coefficient : camera.distortion) {
    key += fmt::format(" {}", coefficient);
  }
  const Eigen::Matrix<double, 3, 4> pose = camera.cameraFromWorld.matrix().topRows<3>();
  for (const double value : pose.reshaped()) {
    key += fmt::format(" {}", value);
  }
  return key;
}

} // namespace

std::shared_ptr<const RoomView> ViewCache::view(const Camera& camera, Furnishing furnishing) {
  std::shared_ptr<Entry> entry;
  {
    const std::lock_guard lock(mutex_);
    auto& slot = entries_[keyOf(camera, furnishing)];
    if (!slot) {
      slot = std::make_shared<Entry>();
    }
    entry = slot;
  }
  std::call_once(entry->once,
                 [&] { entry->view = std::make_shared<const RoomView>(camera, Room(furnishing)); });
  return entry->view;
}

} // namespace dewpoint::simulation
