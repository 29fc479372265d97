// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <chrono>

namespace dewpoint::capture {

/// Where the capture time of a live image comes from.
enum class TimeOrigin {
  Driver,  ///< the driver of the camera, or the camera itself
  Sender,  ///< the sender of a network stream; its clock is related to ours by the fastest packets
  Arrival, ///< the time at which the image arrived here
};

/// Returns the name of an origin, as in tables of capture times: driver, sender or arrival.
constexpr const char* originName(TimeOrigin origin) {
  switch (origin) {
  case TimeOrigin::Driver:
    return "driver";
  case TimeOrigin::Sender:
    return "sender";
  case TimeOrigin::Arrival:
    break;
  }
  return "arrival";
}

/// Capture time of one live image.
struct CaptureInstant {
  std::chrono::steady_clock::time_point time{};
  TimeOrigin origin = TimeOrigin::Arrival;
};

} // namespace dewpoint::capture
