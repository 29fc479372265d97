// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/command.h"
#include "core/session/playback.h"
#include "core/session/run_with_history.h"

#include <cstdint>
#include <optional>

namespace dewpoint::session {

/// Returns the range of frames that must be tracked again so that all results from frame `from` on
/// come from the current settings or, if `method` is not null, from another method. The range
/// begins at the available frame closest to `from`, or earlier if the other method cannot begin
/// there. The remaining frames of a rerun in progress are included. If the range ends before it
/// begins, there is nothing to track again. Returns nothing if no frame is available.
std::optional<RerunState> framesToRerun(const RunWithHistory& current, const Playback& playback,
                                        std::int64_t from, const command::SetMethod* method);

} // namespace dewpoint::session
