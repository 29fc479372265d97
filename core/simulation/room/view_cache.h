// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/room_view.h"

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace dewpoint::simulation {

/// Cache of camera views of rooms at rest. Each view is rendered once, so that many runs of a
/// scenario share one background. The cache is thread-safe. A view never changes after its
/// creation.
class ViewCache {
public:
  /// Returns a camera's view of a room. The first call for a view renders the view.
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
