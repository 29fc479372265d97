// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <chrono>

namespace dewpoint::base {

/// When a frame was taken: nanoseconds since the run's own zero (the first frame of a recording,
/// the opening of a live session). Integer, so that times compare and print exactly.
using TimeStamp = std::chrono::nanoseconds;

/// Seconds as a number, for mathematics and files.
inline double seconds(TimeStamp time) {
  return std::chrono::duration<double>(time).count();
}

/// The time stamp nearest to a number of seconds.
inline TimeStamp timeStamp(double seconds) {
  return std::chrono::round<TimeStamp>(std::chrono::duration<double>(seconds));
}

} // namespace dewpoint::base
