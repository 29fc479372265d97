// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <cstdint>

namespace dewpoint::tracking {

/// Initial box of an image target, from which methods that track boxes learn the target's colors.
struct TargetBox {
  int camera = 0; ///< camera index in the project
  std::int64_t frame = 0;
  ImageBox box; ///< pixels from the upper left corner of the image

  bool operator==(const TargetBox&) const = default;
};

} // namespace dewpoint::tracking
