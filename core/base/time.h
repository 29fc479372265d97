// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <chrono>

namespace dewpoint::base {

/// Capture time of a frame, in nanoseconds since the start of the run (the first frame of a
/// recording, or the start of a live session). Stored as an integer, so that times compare and
/// print exactly.
using TimeStamp = std::chrono::nanoseconds;

/// Converts a time stamp to seconds, for calculations and files.
inline double seconds(TimeStamp time) {
  return std::chrono::duration<double>(time).count();
}

/// Returns the time stamp closest to a time in seconds.
inline TimeStamp timeStamp(double seconds) {
  return std::chrono::round<TimeStamp>(std::chrono::duration<double>(seconds));
}

} // namespace dewpoint::base
