// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <limits>

namespace dewpoint::simulation {

/// When the shutter is open: centered on `time`, for `seconds`; and for which rows of the image,
/// [firstRow, endRow), cut by the image.
struct Exposure {
  double time = 0.0;
  double seconds = 0.0;
  int firstRow = 0;
  int endRow = std::numeric_limits<int>::max();
};

} // namespace dewpoint::simulation
