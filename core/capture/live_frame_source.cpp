// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/live_frame_source.h"

#include "core/capture/frame_source.h"
#include "core/capture/live_camera_thread.h"

#include <algorithm>
#include <utility>

namespace dewpoint::capture {

using namespace std::chrono_literals;

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kLongestWait = 100ms; ///< so that whoever asks stays responsive
constexpr auto kTogether = 40ms;     ///< how long one camera's frame waits for the others'
constexpr auto kStopPatience = 1s;   ///< with threads that do not end, for all cameras together

/// The frame at the time of what it shows.
FramePtr inTime(FramePtr frame, TimeStamp delay) {
  if (!frame || delay == TimeStamp{}) {
    return frame;
  }
  return std::make_shared<const Frame>(
      Frame{frame->index, frame->captureTime - delay, frame->image});
}

class LiveFrameSource final : public FrameSetSource {
public:
  LiveFrameSource(const std::vector<LiveCamera>& cameras, const LiveStreamFactory& factory) {
    cameras_.reserve(cameras.size());
    for (const LiveCamera& camera : cameras) {
      cameras_.emplace_back(camera, factory, bell_, zero_);
      delay_.push_back(timeStamp(camera.delay));
    }
  }

  ~LiveFrameSource() override {
    for (LiveCameraThread& camera : cameras_) {
      camera.requestStop();
    }
    const auto deadline = Clock::now() + kStopPatience;
    for (LiveCameraThread& camera : cameras_) {
      camera.joinUntil(deadline);
    }
  }

  std::optional<std::int64_t> frameCount() const override { return std::nullopt; }
  double framesPerSecond() const override;
  Result<FrameSetPtr> next() override;
  Status seek(std::int64_t) override { return {}; }
  std::int64_t droppedFrames() const override;
  std::vector<Error> notices() const override;

private:
  Clock::time_point dueTime() const;

  Clock::time_point zero_ = Clock::now();
  std::shared_ptr<Bell> bell_ = std::make_shared<Bell>();
  std::vector<LiveCameraThread> cameras_;
  std::vector<TimeStamp> delay_; ///< of the cameras
  std::int64_t sets_ = 0;
  TimeStamp last_{};
};

double LiveFrameSource::framesPerSecond() const {
  for (const LiveCameraThread& camera : cameras_) {
    if (camera.framesPerSecond() > 0) {
      return camera.framesPerSecond();
    }
  }
  return kDefaultFramesPerSecond;
}

/// When the frames at hand make a set: now when all cameras that deliver have one, else as soon as
/// the first has waited long enough; far in the future while there is none.
Clock::time_point LiveFrameSource::dueTime() const {
  auto first = Clock::time_point::max();
  bool complete = true;
  for (const LiveCameraThread& camera : cameras_) {
    const auto since = camera.waitingSince();
    if (since) {
      first = std::min(first, *since);
    } else if (camera.delivers()) {
      complete = false;
    }
  }
  if (first == Clock::time_point::max()) {
    return first;
  }
  return complete ? first : first + kTogether;
}

Result<FrameSetPtr> LiveFrameSource::next() {
  const auto deadline = Clock::now() + kLongestWait;
  for (;;) {
    const auto rings = bell_->rings();
    const auto until = std::min(dueTime(), deadline);
    if (Clock::now() >= until) {
      break;
    }
    bell_->waitBeyond(rings, until);
  }
  auto set = std::make_shared<FrameSet>();
  set->index = sets_++;
  TimeStamp newest{};
  for (LiveCameraThread& camera : cameras_) {
    set->frames.push_back(inTime(camera.take().value_or(nullptr), delay_[set->frames.size()]));
    if (set->frames.back()) {
      newest = std::max(newest, set->frames.back()->captureTime);
    }
  }
  if (newest == TimeStamp{}) {
    newest = std::chrono::duration_cast<TimeStamp>(Clock::now() - zero_);
  }
  // A late camera's frame may be older than what the previous set already showed.
  last_ = set->time = std::max(last_, newest);
  return set;
}

std::int64_t LiveFrameSource::droppedFrames() const {
  std::int64_t sum = 0;
  for (const LiveCameraThread& camera : cameras_) {
    sum += camera.dropped();
  }
  return sum;
}

std::vector<Error> LiveFrameSource::notices() const {
  std::vector<Error> list;
  for (const LiveCameraThread& camera : cameras_) {
    if (auto problem = camera.problem()) {
      list.push_back(std::move(*problem));
    }
  }
  return list;
}

} // namespace

Result<std::unique_ptr<FrameSetSource>> openLive(const std::vector<LiveCamera>& cameras,
                                                 const LiveStreamFactory& factory) {
  if (cameras.empty()) {
    return failure(ErrorCode::MissingKey, "", "camera", "there is no camera to open");
  }
  for (const LiveCamera& camera : cameras) {
    const PictureShape shape{camera.name, camera.rotateDegrees, camera.width, camera.height,
                             camera.mirrored};
    if (auto usable = checkShape(shape, camera.location); !usable) {
      return tl::make_unexpected(usable.error());
    }
  }
  try {
    return std::make_unique<LiveFrameSource>(cameras, factory);
  } catch (const std::exception& problem) { // the system has no more threads
    return failure(ErrorCode::DeviceUnavailable, "", "camera", problem.what());
  }
}

Result<std::unique_ptr<FrameSetSource>> openLive(const std::vector<LiveCamera>& cameras) {
  for (const LiveCamera& camera : cameras) {
    if (auto known = checkLocation(camera); !known) {
      return tl::make_unexpected(known.error());
    }
  }
  return openLive(cameras, makeVideoStream);
}

} // namespace dewpoint::capture
