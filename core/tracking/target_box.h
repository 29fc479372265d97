// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <cstdint>

namespace dewpoint::tracking {

/// The first box of an image target: methods that track boxes learn the target's colors there.
struct TargetBox {
  int camera = 0; ///< in the order of the project
  std::int64_t frame = 0;
  ImageBox box; ///< pixels from the image's upper left corner

  bool operator==(const TargetBox&) const = default;
};

} // namespace dewpoint::tracking
