// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::session {

/// Tracking state of a target, of the view of a camera, or of a frame, shown as one word.
enum class TrackingState {
  NoImages,
  NoTarget,
  NotTracked,
  NoBox,
  Held,
  Ambiguous, ///< another object is about as likely to be the target
  Hidden,
  Searching,
  Lost,
  Missing,
  Learning, ///< backgrounds are being learned before people are searched for
  Nobody,   ///< people are searched for, but none is present
  Gone,     ///< a person who has left or has not yet appeared
};

} // namespace dewpoint::session
