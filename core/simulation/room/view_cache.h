// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/room_view.h"

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace dewpoint::simulation {

/// The views of cameras on rooms at rest, each rendered once: many seeds of a scenario share one
/// background. May be used by several threads; a view does not change once it exists.
class ViewCache {
public:
  std::shared_ptr<const RoomView> view(const Camera& camera, Furnishing furnishing);

private:
  struct Entry {
    std::once_flag once;
    std::shared_ptr<const RoomView> view;
  };
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Entry>> entries_;
};

} // namespace dewpoint::simulation
