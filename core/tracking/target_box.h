// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <cstdint>

namespace dewpoint::tracking {

/// Where the methods that follow boxes learn what a target looks like, and begin to follow it.
struct TargetBox {
  int camera = 0; ///< in the order of the project
  std::int64_t frame = 0;
  ImageBox box; ///< pixels from the image's upper left corner

  bool operator==(const TargetBox&) const = default;
};

} // namespace dewpoint::tracking
