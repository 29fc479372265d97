// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/live_frame_source.h"

#include "core/capture/frame_source.h"
#include "core/capture/live_camera_thread.h"
#include "core/capture/live_pairing.h"
#include "core/capture/redacted_location.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace dewpoint::capture {

using namespace std::chrono_literals;

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kLongestWait = 100ms; ///< so that whoever asks stays responsive
constexpr auto kStopTimeout = 1s;    ///< with threads that do not end, for all cameras together

/// The frame at the time of what it shows.
FramePtr inTime(FramePtr frame, TimeStamp delay) {
  if (delay == TimeStamp{}) {
    return frame;
  }
  Frame shifted = *frame; // shares the pixels
  shifted.captureTime -= delay;
  shifted.instants.capturedAt -=
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(delay);
  return std::make_shared<const Frame>(std::move(shifted));
}

std::vector<TimeStamp> delaysOf(const std::vector<LiveCamera>& cameras) {
  std::vector<TimeStamp> delays;
  std::ranges::transform(cameras, std::back_inserter(delays),
                         [](const LiveCamera& camera) { return timeStamp(camera.delaySeconds); });
  return delays;
}

class LiveFrameSource final : public FrameSetSource {
public:
  LiveFrameSource(const std::vector<LiveCamera>& cameras, const LiveStreamFactory& factory)
      : delays_(delaysOf(cameras)), pairing_(delays_) {
    cameras_.reserve(cameras.size());
    for (const LiveCamera& camera : cameras) {
      cameras_.emplace_back(camera, factory, wakeSignal_, zero_);
    }
  }

  ~LiveFrameSource() override {
    for (LiveCameraThread& camera : cameras_) {
      camera.requestStop();
    }
    const auto deadline = Clock::now() + kStopTimeout;
    for (LiveCameraThread& camera : cameras_) {
      camera.joinUntil(deadline);
    }
  }

  std::optional<std::int64_t> frameCount() const override { return std::nullopt; }
  double framesPerSecond() const override;
  Result<FrameSetPtr> next() override;
  Status seek(std::int64_t) override { return {}; }
  std::int64_t droppedFrameCount() const override;
  std::vector<Error> notices() const override;

private:
  TimeStamp now() const { return std::chrono::duration_cast<TimeStamp>(Clock::now() - zero_); }
  void collect();
  /// The next group of frames; nothing when none is complete until `deadline`.
  std::optional<std::vector<FramePtr>> awaited(Clock::time_point deadline);

  /// The capture time of the oldest image that may come next, while there is none.
  TimeStamp earliestToCome() const;

  Clock::time_point zero_ = Clock::now();
  std::shared_ptr<WakeSignal> wakeSignal_ = std::make_shared<WakeSignal>();
  std::vector<LiveCameraThread> cameras_;
  std::vector<TimeStamp> delays_; ///< of the cameras
  LivePairing pairing_;
  std::int64_t sets_ = 0;
  TimeStamp last_{};
};

double LiveFrameSource::framesPerSecond() const {
  double fastest = 0.0;
  for (const LiveCameraThread& camera : cameras_) {
    fastest = std::max(fastest, camera.framesPerSecond());
  }
  return fastest > 0.0 ? fastest : kDefaultFramesPerSecond;
}

void LiveFrameSource::collect() {
  for (std::size_t k = 0; k < cameras_.size(); ++k) {
    const double rate = cameras_[k].framesPerSecond();
    pairing_.setExpectedTiming(k, cameras_[k].isDelivering(),
                               rate > 0.0 ? timeStamp(1.0 / rate) : TimeStamp{},
                               timeStamp(cameras_[k].latencySeconds()));
    for (FramePtr& frame : cameras_[k].takeFrames()) {
      pairing_.add(k, inTime(std::move(frame), delays_[k]));
    }
  }
}

std::optional<std::vector<FramePtr>> LiveFrameSource::awaited(Clock::time_point deadline) {
  for (;;) {
    const auto notificationCount = wakeSignal_->notificationCount();
    collect();
    if (auto frames = pairing_.takeGroup(now())) {
      return frames;
    }
    if (Clock::now() >= deadline) {
      return std::nullopt;
    }
    const auto due = pairing_.dueTime();
    wakeSignal_->waitForNewNotification(notificationCount,
                                        due ? std::min(zero_ + *due, deadline) : deadline);
  }
}

TimeStamp LiveFrameSource::earliestToCome() const {
  TimeStamp behind{};
  for (std::size_t k = 0; k < cameras_.size(); ++k) {
    behind = std::max(behind, delays_[k] + timeStamp(cameras_[k].latencySeconds()));
  }
  const TimeStamp coming = now() - behind;
  return std::min(coming, pairing_.oldestFrameTime().value_or(coming));
}

Result<FrameSetPtr> LiveFrameSource::next() {
  auto set = std::make_shared<FrameSet>();
  set->index = sets_++;
  set->frames = awaited(Clock::now() + kLongestWait)
                    .value_or(std::vector<FramePtr>(cameras_.size(), nullptr));
  TimeStamp newest{};
  for (const FramePtr& frame : set->frames) {
    newest = frame ? std::max(newest, frame->captureTime) : newest;
  }
  if (newest == TimeStamp{}) {
    newest = earliestToCome();
  }
  // A late camera's frame may be older than what the previous set already showed.
  last_ = set->time = std::max(last_, newest);
  return set;
}

std::int64_t LiveFrameSource::droppedFrameCount() const {
  std::int64_t sum = pairing_.droppedCount();
  for (const LiveCameraThread& camera : cameras_) {
    sum += camera.droppedCount();
  }
  return sum;
}

std::vector<Error> LiveFrameSource::notices() const {
  std::vector<Error> list;
  for (const LiveCameraThread& camera : cameras_) {
    if (auto problem = camera.problem()) {
      list.push_back(std::move(*problem));
    } else if (auto fault = camera.imageFault()) {
      list.push_back(std::move(*fault));
    }
    if (auto warning = camera.warning()) {
      list.push_back(std::move(*warning));
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
    const ImageShape shape{camera.name,   camera.rotateDegrees, camera.width,
                           camera.height, camera.isMirrored,    camera.crop};
    if (auto usable = checkShape(shape, redactedLocation(camera.location)); !usable) {
      return tl::make_unexpected(usable.error());
    }
  }
  try {
    return std::make_unique<LiveFrameSource>(cameras, factory);
  } catch (const std::exception& problem) { // the system has no more threads
    return failure(ErrorCode::DeviceUnavailable, "", "camera", problem.what());
  }
}

} // namespace dewpoint::capture
