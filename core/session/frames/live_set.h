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
    /// Number that identifies the image within the connection of its camera; -1 if there is no such
    /// number.
    std::int64_t imageNumber = -1;
    /// Capture time of the image by the camera's own clock.
    TimeStamp captureTime{};
  };

  std::int64_t index = 0;                   ///< number of the frame
  TimeStamp time{};                         ///< time of the frame
  std::vector<std::optional<Image>> images; ///< one per camera; empty if the camera had no image
};

} // namespace dewpoint::session
