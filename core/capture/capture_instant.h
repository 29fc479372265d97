// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <chrono>
#include <cstdint>

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
  /// Identifies the image within its connection: the same for the compressed and the decoded image;
  /// -1 if there is none.
  std::int64_t stamp = -1;
};

/// When a live image passed the stages of its way through the computer.
struct LiveInstants {
  std::chrono::steady_clock::time_point
      captured{};                                  ///< see CaptureInstant, minus the camera's delay
  std::chrono::steady_clock::time_point arrived{}; ///< its data were here, not yet decoded
  std::chrono::steady_clock::time_point decoded{}; ///< the image was finished
  std::int64_t stamp = -1;                         ///< CaptureInstant::stamp
};

} // namespace dewpoint::capture
