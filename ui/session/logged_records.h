// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/frames/tracked_frame.h"
#include "core/session/log/log_update.h"
#include "core/session/snapshot/snapshot.h"

namespace dewpoint::ui {

/// Records of the frames tracked since the last signal with such records. This is a separate type
/// so that it can be forward-declared.
struct LoggedFrames : LogUpdate<FrameRecord> {};

/// Records of the filter iterations made since the last signal with such records.
struct LoggedIterations : LogUpdate<IterationRecord> {};

} // namespace dewpoint::ui
