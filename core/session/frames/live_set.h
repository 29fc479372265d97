// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/time.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::session {

/// Identifies the images of live cameras that a run tracked in one frame.
struct LiveFrameRecord {
  struct Image {
    std::int64_t stamp = -1; ///< CaptureInstant::stamp
    TimeStamp captureTime{}; ///< Frame::captureTime
  };

  std::int64_t index = 0;                   ///< FrameSet::index
  TimeStamp time{};                         ///< FrameSet::time
  std::vector<std::optional<Image>> images; ///< one per camera; empty if the camera had no image
};

} // namespace dewpoint::session
