// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"
#include "core/capture/frame_queue.h"
#include "core/capture/image_health.h"
#include "core/capture/image_shape.h"
#include "core/capture/live_stream.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace dewpoint::capture {

/// Wakes up the reader of several cameras whenever one of them has a new frame or changes state.
class WakeSignal {
public:
  using Clock = std::chrono::steady_clock;

  /// Counts a notification and wakes up the waiting reader.
  void notify();
  /// Returns the number of notifications so far.
  std::uint64_t notificationCount() const;
  /// Waits until there have been more than `known` notifications, or until the deadline.
  void waitForNewNotification(std::uint64_t known, Clock::time_point deadline);

private:
  mutable std::mutex mutex_;
  std::condition_variable notified_;
  std::uint64_t notifyCount_ = 0;
};

/// Opens and reads one camera in a separate thread, and opens it again when the connection is lost.
/// If a read never returns, the thread can be abandoned safely.
class LiveCameraThread {
public:
  using Clock = std::chrono::steady_clock;

  /// Starts the thread. It notifies `wakeSignal` for each new frame and each change of state. Times
  /// of frames are measured from `zeroTime`.
  LiveCameraThread(const LiveCamera& camera, LiveStreamFactory factory,
                   std::shared_ptr<WakeSignal> wakeSignal, Clock::time_point zeroTime);
  ~LiveCameraThread();
  LiveCameraThread(LiveCameraThread&&) noexcept = default;
  LiveCameraThread& operator=(LiveCameraThread&&) = delete;

  /// Asks the thread to stop, without waiting for it.
  void requestStop();
  /// Waits until the thread has ended. At the deadline, abandons a thread that is still running.
  void joinUntil(Clock::time_point deadline);

  /// Removes and returns the frames since the last call, oldest first.
  std::vector<FramePtr> takeFrames() { return shared_->frames.takeAll(); }
  /// Returns the number of frames dropped because they were not read in time.
  std::int64_t droppedCount() const { return shared_->frames.droppedCount(); }
  /// Returns whether the camera is expected to deliver frames.
  bool isDelivering() const;
  /// Returns the camera's current problem, or nothing if there is none.
  std::optional<Error> problem() const;
  /// Returns a problem of the camera that does not prevent it from delivering images, or nothing if
  /// there is none (LiveStream::warning()).
  std::optional<Error> warning() const;
  /// Returns the fault of the images of the last second, or nothing if they are fine (ImageHealth).
  std::optional<Error> imageFault() const;
  /// Returns the smoothed frame rate in images per second; 0 before the second image.
  double framesPerSecond() const { return shared_->framesPerSecond; }
  /// Returns the time from the capture of an image to its arrival, seconds. It is close to the
  /// longest such time among the latest images. 0 if the connection does not report capture times.
  double latencySeconds() const { return shared_->latencySeconds; }

private:
  /// Maximum number of frames that wait to be read. A camera sends fewer frames than this between
  /// two reads.
  static constexpr std::size_t kMaxFrames = 16;

  struct Shared {
    LiveCamera camera;
    ImageShape shape; ///< used only by the camera's thread
    LiveStreamFactory factory;
    std::shared_ptr<WakeSignal> wakeSignal;
    Clock::time_point zeroTime;

    FrameQueue frames{kMaxFrames};
    std::atomic<double> framesPerSecond{0};
    std::atomic<double> latencySeconds{0};

    mutable std::mutex mutex; ///< guards all members below
    std::condition_variable_any stateChanged;
    bool isConnected = false;
    bool hasDelivered = false;
    bool hasGrabbed = false; ///< the current connection has delivered an image
    bool hasFinished = false;
    Clock::time_point
        openingStartTime{}; ///< start of the current connection attempt, while not connected
    Clock::time_point lastGrabTime{};
    std::optional<Error> problem;
    std::string warning; ///< of the stream that is open
    ImageHealth health;
  };
  struct Progress;

  static void run(const std::stop_token& stop, Shared& shared);
  static void readAll(const std::stop_token& stop, Shared& shared, LiveStream& stream,
                      Progress& progress);
  /// When an image was grabbed, when its data had arrived, and when it was captured.
  struct Grabbed {
    Clock::time_point grabTime{};
    Clock::time_point arrivalTime{};
    CaptureInstant captureInstant;
  };
  static void publish(Shared& shared, const cv::Mat& picture, const Grabbed& grabbed,
                      Progress& progress);
  static Clock::duration silenceTimeout(const Shared& shared);
  static void setProblem(Shared& shared, Error problem);
  static void setDisconnected(Shared& shared, const std::string& detail);

  std::shared_ptr<Shared> shared_;
  std::jthread thread_;
};

} // namespace dewpoint::capture
