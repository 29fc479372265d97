// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/command.h"
#include "core/session/playback.h"
#include "core/session/run_with_history.h"

#include <cstdint>
#include <optional>

namespace dewpoint::session {

/// Returns the frames that must be tracked again so that the results are those of the current
/// settings, or of another method, from frame `from` on. They begin at the nearest frame that is
/// available, and earlier if the other method cannot begin there. If a rerun is in progress, its
/// remaining frames are included. The last frame is before the first if nothing was tracked there
/// yet. Nothing if there are no frames at all.
std::optional<RerunState> framesToRerun(const RunWithHistory& current, const Playback& playback,
                                        std::int64_t from, const command::SetMethod* method);

} // namespace dewpoint::session
