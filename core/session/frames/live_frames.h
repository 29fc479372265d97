// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/frames/frame_cache.h"

#include <cstddef>
#include <memory>

namespace dewpoint::session {

/// Returns a cache of frames from live cameras. The newest frames are kept uncompressed, older ones
/// as JPEG, which a separate thread compresses. The cache uses at most `maxBytes` of memory.
std::unique_ptr<LiveFrameCache> makeLiveFrameCache(std::size_t maxBytes);

} // namespace dewpoint::session
