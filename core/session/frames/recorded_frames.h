// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_source.h"
#include "core/session/frames/frame_cache.h"

#include <cstddef>
#include <memory>

namespace dewpoint::session {

/// Frames of a recording, read again by seeking; those decoded last are kept, and small pictures of
/// all that went by, up to `mostBytes`. When frames are requested backwards, some earlier ones are
/// decoded on the way. Moves the source.
std::unique_ptr<FrameCache> recordedFrames(FrameSetSource& source, std::size_t mostBytes);

} // namespace dewpoint::session
