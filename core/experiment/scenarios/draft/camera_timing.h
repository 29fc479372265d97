// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"

#include <cstdint>
#include <optional>

namespace dewpoint::experiment::scenarios {

/// Timing faults of a camera, which methods do not know. The time stamp of a frame is its arrival
/// time minus the known part of the camera's delay; the delays in this struct come in addition.
struct CameraTiming {
  double delaySeconds = 0.0;  ///< unknown delay: time from mid-exposure to the time stamp, seconds
  double clockDrift = 0.0;    ///< increase of the unknown delay, seconds per second
  double jitterSeconds = 0.0; ///< standard deviation of the errors of the time stamps, seconds
  double droppedFrameShare = 0.0;  ///< fraction of frames that do not arrive
  double repeatedFrameShare = 0.0; ///< fraction of frames that repeat the previous image
  /// Frames in the range [freezeBegin, freezeEnd) repeat the last image before this range, with new
  /// time stamps.
  std::int64_t freezeBegin = 0;
  std::int64_t freezeEnd = 0;
};

/// What arrives for a frame of a camera: which image, and the error of its time stamp.
struct FrameDelivery {
  std::int64_t shownFrame = 0; ///< number of the frame whose image arrives
  double timeStampError = 0.0; ///< error of the time stamp, seconds
};

/// Returns what arrives for frame `frame` of a camera, or nothing if the frame is dropped. Frame 0
/// always arrives and shows its own image. `chances` is the random stream of this camera and frame.
/// This is a pure function.
std::optional<FrameDelivery> deliveryOf(const CameraTiming& timing, std::int64_t frame,
                                        const RandomStream& chances);

/// Returns the mid-exposure time (seconds) of a frame with the time stamp `stamp` (seconds).
double midExposureTime(const CameraTiming& timing, double stamp);

} // namespace dewpoint::experiment::scenarios
