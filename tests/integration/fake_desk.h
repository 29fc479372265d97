// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/gstreamer/buffer_clock.h"
#include "core/capture/live_stream.h"
#include "core/simulation/scene/scene.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::tests {

/// How an image is spoiled.
enum class Spoiled { No, OtherSize, Empty, Noise, Torn, Gray, Deep, Undecodable };

/// An image on its way from a fake camera to its reader.
struct Shot {
  std::int64_t tick = 0;
  Spoiled spoiled = Spoiled::No;
  std::chrono::hours stampOff{0};
};

/// A camera on the fake desk; guarded by the mutex of the desk.
struct FakeCamera {
  int number = 0;
  std::string port;
  std::string serial;
  int node = -1;            ///< number below /dev; -1: not plugged in
  std::int64_t plugins = 0; ///< number of times it was plugged in; older connections are lost
  bool isFrozen = false;
  std::deque<Shot> spoiled; ///< how the next images are spoiled, in order
  int duplicates = 0;
  int reorders = 0;
  int held = 0; ///< images that are held back, to come at once

  bool isPlugged() const { return node >= 0; }
  /// Cancels everything that was about to happen to its images.
  void clear();
};

/// The demo's ball, which moves in rounds, and four cameras around it. Their images arrive in real
/// time.
struct FakeDesk {
  using Clock = std::chrono::steady_clock;
  static constexpr int kCameras = 4;
  static constexpr int kWidth = 320;
  static constexpr int kHeight = 240;
  static constexpr double kTicksPerSecond = 30.0;
  static constexpr std::int64_t kRoundTicks = 120;

  Scene scene;
  std::array<std::vector<cv::Mat>, kCameras>
      film; ///< of the second round, because the first starts slowly
  Clock::time_point begin;
  std::atomic<int> connections = 0;

  std::mutex mutex;
  std::condition_variable changed;
  std::array<FakeCamera, kCameras> cameras;

  /// Renders the film, which takes a second or two.
  FakeDesk();
  Clock::time_point timeOf(std::int64_t tick) const;
  std::int64_t now() const;
  /// Returns the position of the ball at a tick, meters.
  Eigen::Vector3d ballAt(std::int64_t tick) const;
  /// Returns the camera with this node; null if there is none. Needs the mutex.
  FakeCamera* at(const std::string& path);
};

/// A connection to the camera that has the node `path` when the connection is opened. It holds a
/// file handle, like a connection through a driver. Each image carries the number of its camera and
/// of its tick (ImageTag).
class FakeDeskStream final : public LiveStream {
public:
  FakeDeskStream(std::shared_ptr<FakeDesk> desk, std::string path);
  ~FakeDeskStream() override;

  tl::expected<void, std::string> open() override;
  bool grab() override;
  cv::Mat retrieve() override;
  std::optional<CaptureInstant> captureTime() const override { return captured_; }
  std::string lostReason() const override { return "it was unplugged"; }

private:
  bool isLost() const { return camera_->plugins != plugin_ || !camera_->isPlugged(); }
  bool waitFor(std::unique_lock<std::mutex>& lock, std::int64_t tick);
  /// Waits for the next images. Returns whether the camera is still there.
  bool collect(std::unique_lock<std::mutex>& lock);
  void spoil(cv::Mat& image) const;

  std::shared_ptr<FakeDesk> desk_;
  std::string path_;
  FakeCamera* camera_ = nullptr;
  int number_ = 0; ///< of the camera
  std::int64_t plugin_ = 0;
  int handle_ = -1;
  std::int64_t next_ = 0;
  std::deque<Shot> waiting_;
  Shot shot_;
  BufferClock clock_{TimeOrigin::Driver};
  std::optional<CaptureInstant> captured_;
};

} // namespace dewpoint::tests
