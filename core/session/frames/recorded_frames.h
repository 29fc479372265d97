// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_source.h"
#include "core/session/frames/frame_cache.h"

#include <cstddef>
#include <memory>

namespace dewpoint::session {

/// Returns a cache of the frames of a recording. The cache keeps the most recently decoded frames
/// and small images of all past frames, in at most `maxBytes` of memory. Other frames are read
/// again from `source`, which changes the position of `source`. When frames are requested in
/// backward order, some earlier ones are decoded ahead.
std::unique_ptr<FrameCache> makeRecordedFrameCache(FrameSetSource& source, std::size_t maxBytes);

} // namespace dewpoint::session
