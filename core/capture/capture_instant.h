// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <chrono>
#include <cstdint>

namespace dewpoint::capture {

/// Origin of the capture time of a live image.
enum class TimeOrigin {
  Driver, ///< the driver of the camera, or the camera itself
  /// The sender of a network stream; the packets with the shortest delay relate its clock to ours.
  Sender,
  Arrival, ///< the time at which the image arrived at this computer
};

/// Returns the name of an origin as written to tables of capture times: driver, sender or arrival.
constexpr const char* timeOriginName(TimeOrigin origin) {
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
  /// Number that identifies the image within its connection, both in compressed and in decoded
  /// form; -1 if the connection provides no such number.
  std::int64_t imageId = -1;
};

/// Times at which a live image passed the stages of its processing.
struct LiveInstants {
  /// Time at which the image was taken: CaptureInstant::time minus the camera's delay.
  std::chrono::steady_clock::time_point capturedAt{};
  std::chrono::steady_clock::time_point
      arrivedAt{}; ///< arrival of the image's data, before decoding
  std::chrono::steady_clock::time_point decodedAt{}; ///< end of decoding of the image
  std::int64_t imageId = -1; ///< number of the image in its connection (CaptureInstant::imageId)
};

} // namespace dewpoint::capture
