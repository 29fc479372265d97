// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <limits>

namespace dewpoint::simulation {

/// Exposure of the image rows [firstRow, endRow). The shutter is open for `durationSeconds`,
/// centered on `centerTime` (seconds). Rows outside the image are ignored.
struct Exposure {
  double centerTime = 0.0;
  double durationSeconds = 0.0;
  int firstRow = 0;
  int endRow = std::numeric_limits<int>::max();
};

} // namespace dewpoint::simulation
