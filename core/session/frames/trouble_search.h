// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/frames/tracked_frame.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace dewpoint::session {

/// Returns the frame closest after (`direction` > 0) or before (`direction` < 0) the frame `from`
/// in which trouble begins, or nothing if there is none. `records` are in increasing frame order.
/// Trouble begins where a target becomes ambiguous, searching or lost and was not any of these in
/// the record before, and where a live camera has a problem that it did not have in the record
/// before. A target that is removed or not yet created is no trouble. If `target` is given, the
/// other targets are ignored; problems of cameras always count.
std::optional<std::int64_t> nextTrouble(std::span<const FrameRecord> records, std::int64_t from,
                                        int direction,
                                        std::optional<std::size_t> target = std::nullopt);

} // namespace dewpoint::session
