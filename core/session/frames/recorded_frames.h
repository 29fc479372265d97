// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_source.h"
#include "core/session/frames/frame_cache.h"

#include <cstddef>
#include <memory>

namespace dewpoint::session {

/// Returns a cache of frames of a recording, which are read again by seeking. It keeps the most
/// recently decoded frames, and small images of all past frames, up to `maxBytes`. When frames are
/// requested backward, some earlier ones are decoded at the same time. The cache changes the
/// position of `source`.
std::unique_ptr<FrameCache> makeRecordedFrameCache(FrameSetSource& source, std::size_t maxBytes);

} // namespace dewpoint::session
