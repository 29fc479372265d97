// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::session {

/// The state of a target, of a camera or of a frame that a view shows in one word.
enum class HoldState {
  NoImages,
  NoTarget,
  NotTracked,
  NoBox,
  Held,
  Ambiguous, ///< something else may be the target about as well
  Hidden,
  Searching,
  Lost,
  Missing,
  Learning, ///< the backgrounds, before people are searched for
  Nobody,   ///< people are searched for, and nobody is there
  Gone,     ///< a person who has left, or is not there yet
};

} // namespace dewpoint::session
