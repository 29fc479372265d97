// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"

#include <cstdint>
#include <optional>

namespace dewpoint::experiment::scenarios {

/// What is wrong with when the frames of a camera come. A frame's time stamp is that of its arrival
/// less the delay that is known; what is not known of the delay is here.
struct CameraTiming {
  double delay = 0.0;       ///< the exposure's middle is earlier than the stamp says, seconds
  double clockDrift = 0.0;  ///< seconds by which the delay grows per second
  double jitter = 0.0;      ///< standard deviation of the time stamps, seconds
  double dropShare = 0.0;   ///< of the frames do not come
  double doubleShare = 0.0; ///< of the frames show what the one before shows
  /// Frames [freezeBegin, freezeEnd) all show the last image before them, with new time stamps.
  std::int64_t freezeBegin = 0;
  std::int64_t freezeEnd = 0;
};

/// A frame as it comes: which image it shows, and how much its time stamp is off.
struct Delivery {
  std::int64_t shown = 0;  ///< number of the frame whose image comes
  double stampError = 0.0; ///< seconds
};

/// How frame `frame` of a camera comes; nothing when it is dropped. A pure function; `chances` is
/// the camera's stream of the frame. Frame 0 always comes as it is.
std::optional<Delivery> delivered(const CameraTiming& timing, std::int64_t frame,
                                  const RandomStream& chances);

/// When a frame that is stamped `stamp` (seconds) was taken: the middle of its exposure.
double exposureTime(const CameraTiming& timing, double stamp);

} // namespace dewpoint::experiment::scenarios
