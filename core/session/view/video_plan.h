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

/// Number of a frame of a run, and its time.
struct FrameTime {
  std::int64_t frame = 0;
  double timeSeconds = 0.0;
};

/// Playing speed and frame rate of an exported video.
struct VideoTiming {
  static constexpr double kMinPlaybackSpeed = 0.01;
  static constexpr double kMaxPlaybackSpeed = 100.0;

  /// Speed as a factor relative to real time, from kMinPlaybackSpeed to kMaxPlaybackSpeed. If not
  /// set, every frame is shown exactly once, regardless of its time.
  std::optional<double> playbackSpeed = 1.0;
  double framesPerSecond = 30.0; ///< frame rate of the video, 1 to 1000
};

/// Largest number of images in an exported video: enough for more than a day at 60 frames per
/// second.
inline constexpr std::size_t kMaxVideoImages = 6'000'000;

/// Returns the number of the frame that each image of a video shows. Image k shows the frame
/// closest in time to `k * playbackSpeed / framesPerSecond` seconds after the first frame. Frames
/// are therefore repeated or left out, and gaps in the recording keep their length. The last frame
/// lasts as long as the median frame. `frames` must be in increasing order of time. Returns
/// BadValue if there is no frame, if the timing is out of range, or if the video would have more
/// than kMaxVideoImages images.
Result<std::vector<std::int64_t>> chooseVideoFrames(std::span<const FrameTime> frames,
                                                    const VideoTiming& timing);

} // namespace dewpoint::session
