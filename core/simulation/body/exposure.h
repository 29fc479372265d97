// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <limits>

namespace dewpoint::simulation {

/// Time during which the shutter is open, for the image rows [firstRow, endRow). It lasts `seconds`
/// and is centered on `time` (seconds). Rows outside the image are ignored.
struct Exposure {
  double time = 0.0;
  double seconds = 0.0;
  int firstRow = 0;
  int endRow = std::numeric_limits<int>::max();
};

} // namespace dewpoint::simulation
