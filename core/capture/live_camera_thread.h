// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"
#include "core/capture/frame_queue.h"
#include "core/capture/live_stream.h"
#include "core/capture/picture.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace dewpoint::capture {

/// Wakes the reader of several cameras whenever one of them has news.
class Bell {
public:
  using Clock = std::chrono::steady_clock;

  void ring();
  std::uint64_t rings() const;
  /// Returns when there were more rings than `known`, or at the deadline.
  void waitBeyond(std::uint64_t known, Clock::time_point deadline);

private:
  mutable std::mutex mutex_;
  std::condition_variable rung_;
  std::uint64_t rings_ = 0;
};

/// Opens one camera, reads it, and opens it again when it is lost, in a thread of its own. What
/// the thread touches is shared with it, so that a read that never returns can be left behind.
class LiveCameraThread {
public:
  using Clock = std::chrono::steady_clock;

  /// `bell` rings on each new frame and each change of state; times count from `zero`.
  LiveCameraThread(const LiveCamera& camera, LiveStreamFactory factory, std::shared_ptr<Bell> bell,
                   Clock::time_point zero);
  ~LiveCameraThread();
  LiveCameraThread(LiveCameraThread&&) noexcept = default;
  LiveCameraThread& operator=(LiveCameraThread&&) = delete;

  void requestStop();
  /// Waits for the thread until the deadline, then abandons it.
  void joinUntil(Clock::time_point deadline);

  /// The frames that came since the last call, oldest first.
  std::vector<FramePtr> takeFrames() { return shared_->frames.takeAll(); }
  std::int64_t dropped() const { return shared_->frames.dropped(); }
  /// Whether frames are to be expected from it.
  bool delivers() const;
  /// What is wrong at present.
  std::optional<Error> problem() const;
  /// Pictures per second, smoothed; 0 before the second one.
  double framesPerSecond() const { return shared_->rate; }

private:
  /// Kept while nobody takes them: more than a camera sends until the reader looks again.
  static constexpr std::size_t kMostFrames = 16;

  struct Shared {
    LiveCamera camera;
    PictureShape shape; ///< used by the camera's thread alone
    LiveStreamFactory factory;
    std::shared_ptr<Bell> bell;
    Clock::time_point zero;

    FrameQueue frames{kMostFrames};
    std::atomic<double> rate{0};

    mutable std::mutex mutex; ///< guards all below
    std::condition_variable_any changed;
    bool connected = false;
    bool everDelivered = false;
    bool finished = false;
    Clock::time_point openingSince{}; ///< of the attempt under way, while not connected
    Clock::time_point lastGrab{};
    std::optional<Error> problem;
  };
  struct Progress;

  static void run(const std::stop_token& stop, Shared& shared);
  static void readAll(const std::stop_token& stop, Shared& shared, LiveStream& stream,
                      Progress& progress);
  static void publish(Shared& shared, const cv::Mat& picture, Clock::time_point grabbed,
                      Progress& progress);
  static void setProblem(Shared& shared, Error problem);
  static void setDown(Shared& shared, const std::string& detail);

  std::shared_ptr<Shared> shared_;
  std::jthread thread_;
};

} // namespace dewpoint::capture
