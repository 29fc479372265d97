// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"

#include <cstdint>
#include <optional>

namespace dewpoint::experiment::scenarios {

/// Timing faults of the frames of a camera. The time stamp of a frame is its arrival time minus the
/// known delay; this describes the unknown part of the delay.
struct CameraTiming {
  double delay = 0.0;       ///< seconds from mid-exposure to the time stamp
  double clockDrift = 0.0;  ///< seconds by which the delay grows per second
  double jitter = 0.0;      ///< standard deviation of the time stamps, seconds
  double dropShare = 0.0;   ///< share of frames that do not arrive
  double doubleShare = 0.0; ///< share of frames that repeat the previous image
  /// Frames [freezeBegin, freezeEnd) all show the last image before them, with new time stamps.
  std::int64_t freezeBegin = 0;
  std::int64_t freezeEnd = 0;
};

/// Frame as it arrives: the image it shows and the error of its time stamp.
struct Delivery {
  std::int64_t shown = 0;  ///< number of the frame whose image arrives
  double stampError = 0.0; ///< seconds
};

/// Delivery of frame `frame` of a camera; nothing if it is dropped. A pure function; `chances` is
/// the camera's random stream for the frame. Frame 0 always arrives without faults.
std::optional<Delivery> delivered(const CameraTiming& timing, std::int64_t frame,
                                  const RandomStream& chances);

/// Mid-exposure time, in seconds, of a frame with the time stamp `stamp` (seconds).
double exposureTime(const CameraTiming& timing, double stamp);

} // namespace dewpoint::experiment::scenarios
