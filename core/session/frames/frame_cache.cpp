// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/frames/frame_cache.h"

namespace dewpoint::session {

std::size_t bytesOf(const FrameSet& frames) {
  std::size_t bytes = 0;
  for (const FramePtr& frame : frames.frames) {
    bytes += frame ? frame->image.total() * frame->image.elemSize() : 0;
  }
  return bytes;
}

} // namespace dewpoint::session
