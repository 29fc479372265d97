// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/frames/tracked_frame.h"
#include "core/session/log_update.h"
#include "core/session/snapshot/snapshot.h"

namespace dewpoint::ui {

/// Frames tracked since the last signal. A separate type, so that signals can use a forward
/// declaration.
struct LoggedFrames : LogUpdate<FrameRecord> {};

/// Filter iterations since the last signal.
struct LoggedIterations : LogUpdate<IterationRecord> {};

} // namespace dewpoint::ui
