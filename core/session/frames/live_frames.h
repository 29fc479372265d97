// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/frames/frame_cache.h"

#include <cstddef>
#include <memory>

namespace dewpoint::session {

/// Frames of live cameras: the newest as they are, older ones as JPEG, compressed by a thread of
/// its own, up to `mostBytes` in all.
std::unique_ptr<FrameCache> liveFrames(std::size_t mostBytes);

} // namespace dewpoint::session
