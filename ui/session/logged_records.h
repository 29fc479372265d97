// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/frames/tracked_frame.h"
#include "core/session/run/snapshot.h"

#include <vector>

namespace dewpoint::ui {

/// Frames tracked since the last report; all frames of the run if it was `restarted`.
struct LoggedFrames {
  std::vector<FrameRecord> records;
  bool restarted = false;
};

/// Iterations of the filter since the last report; all of the run if it was `restarted`.
struct LoggedIterations {
  std::vector<IterationRecord> records;
  bool restarted = false;
};

} // namespace dewpoint::ui
