// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/view/video_plan.h"

#include "core/base/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace dewpoint::session {
namespace {

constexpr double kSingleFrame = 1.0 / 30.0; ///< seconds that a video of one frame lasts

double medianInterval(std::span<const FrameTime> frames) {
  std::vector<double> intervals;
  for (std::size_t k = 1; k < frames.size(); ++k) {
    intervals.push_back(frames[k].timeSeconds - frames[k - 1].timeSeconds);
  }
  return intervals.empty() ? kSingleFrame : std::max(0.0, base::median(std::move(intervals)));
}

Status checkTiming(const VideoTiming& timing) {
  const auto isWithin = [](double value, double low, double high) {
    return std::isfinite(value) && value >= low && value <= high;
  };
  if (timing.playbackSpeed && !isWithin(*timing.playbackSpeed, VideoTiming::kMinPlaybackSpeed,
                                        VideoTiming::kMaxPlaybackSpeed)) {
    return failure(ErrorCode::BadValue, "", "speed",
                   fmt::format("{} is not between {} and {}", *timing.playbackSpeed,
                               VideoTiming::kMinPlaybackSpeed, VideoTiming::kMaxPlaybackSpeed));
  }
  if (!isWithin(timing.framesPerSecond, 1.0, 1000.0)) {
    return failure(ErrorCode::BadValue, "", "frames per second",
                   fmt::format("{} is not between 1 and 1000", timing.framesPerSecond));
  }
  return {};
}

} // namespace

Result<std::vector<std::int64_t>> chooseVideoFrames(std::span<const FrameTime> frames,
                                                    const VideoTiming& timing) {
  if (frames.empty()) {
    return failure(ErrorCode::BadValue, "", "", "there is no frame in this range of times");
  }
  if (const Status valid = checkTiming(timing); !valid) {
    return tl::make_unexpected(valid.error());
  }
  const double step = timing.playbackSpeed.value_or(1.0) / timing.framesPerSecond;
  const double length =
      frames.back().timeSeconds - frames.front().timeSeconds + medianInterval(frames);
  const double count = timing.playbackSpeed ? std::max(1.0, std::round(length / step))
                                            : static_cast<double>(frames.size());
  if (!(count <= static_cast<double>(kMaxVideoImages))) {
    return failure(ErrorCode::BadValue, "", "",
                   fmt::format("the video would have more than {} images", kMaxVideoImages));
  }
  std::vector<std::int64_t> shown;
  shown.reserve(static_cast<std::size_t>(count));
  if (!timing.playbackSpeed) {
    std::ranges::transform(frames, std::back_inserter(shown), &FrameTime::frame);
    return shown;
  }
  std::size_t at = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    const double time = frames.front().timeSeconds + static_cast<double>(k) * step;
    // The later of two frames only if it is closer, by more than rounding.
    while (at + 1 < frames.size() &&
           time - frames[at].timeSeconds > frames[at + 1].timeSeconds - time + 1e-9) {
      ++at;
    }
    shown.push_back(frames[at].frame);
  }
  return shown;
}

} // namespace dewpoint::session
