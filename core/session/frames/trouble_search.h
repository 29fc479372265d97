// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/frames/tracked_frame.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace dewpoint::session {

/// Returns the nearest frame after (`direction` > 0) or before (`direction` < 0) the frame `from`
/// in which trouble begins; nothing if there is none. Trouble begins in a frame where a target
/// becomes ambiguous, searching or lost and was in none of these states in the previous record, or
/// where a live camera has a problem that it did not have there. A target that is removed or not
/// yet created is not in trouble. If the index `target` is given, other targets are ignored; camera
/// problems always count. `records` are in increasing frame order.
std::optional<std::int64_t> nextTrouble(std::span<const FrameRecord> records, std::int64_t from,
                                        int direction,
                                        std::optional<std::size_t> target = std::nullopt);

} // namespace dewpoint::session
