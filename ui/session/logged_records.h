// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/frames/tracked_frame.h"
#include "core/session/log_piece.h"
#include "core/session/snapshot/snapshot.h"

namespace dewpoint::ui {

/// Frames that were tracked since the last time. A type of its own, so that signals can name it
/// without the records.
struct LoggedFrames : LogPiece<FrameRecord> {};

/// The same of the filter's iterations.
struct LoggedIterations : LogPiece<IterationRecord> {};

} // namespace dewpoint::ui
