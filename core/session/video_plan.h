// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/video_encoder.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace dewpoint::session {

/// Frame of a run and its time.
struct FrameTime {
  std::int64_t frame = 0;
  double seconds = 0.0;
};

/// How fast an exported video shows a run.
struct VideoTiming {
  static constexpr double kSlowest = 0.01;
  static constexpr double kFastest = 100.0;

  /// Factor relative to real time, kSlowest to kFastest. If it is not set, every frame is shown
  /// exactly once, whatever its time.
  std::optional<double> speed = 1.0;
  double framesPerSecond = 30.0; ///< of the video
};

/// Largest number of images in an exported video: more than a day at 60 per second.
inline constexpr std::size_t kMaxVideoImages = 6'000'000;

/// Returns the frame that each image of a video shows. Image k shows the frame whose time is
/// closest to `k * speed / framesPerSecond` after the first frame; so frames are repeated or left
/// out, and gaps in the recording last as long as they lasted. `frames` must be in increasing order
/// of time; the last frame is shown for as long as the median frame. Errors: BadValue, if there is
/// no frame, if the timing is out of range, or if there would be more than kMaxVideoImages.
Result<std::vector<std::int64_t>> videoFrames(std::span<const FrameTime> frames,
                                              const VideoTiming& timing);

} // namespace dewpoint::session
