// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/frames/tracked_frame.h"
#include "core/session/run/snapshot.h"

#include <vector>

namespace dewpoint::ui {

/// Frames that were tracked since the last time; all of the run when it was `restarted`.
struct LoggedFrames {
  std::vector<FrameRecord> records;
  bool restarted = false;
};

/// The same of the filter's iterations.
struct LoggedIterations {
  std::vector<IterationRecord> records;
  bool restarted = false;
};

} // namespace dewpoint::ui
