// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/background_patch.h"
#include "core/camera_motion/camera_rotation.h"
#include "core/capture/frame.h"
#include "core/geometry/camera.h"

#include <deque>
#include <optional>
#include <vector>

namespace dewpoint::camera_motion {

/// Report that a camera has moved since it was calibrated.
struct CameraMotionEvent {
  std::size_t camera = 0;
  std::int64_t frame = 0; ///< frame in which the motion became certain
  TimeStamp time{};
  CameraRotation turn; ///< rotation relative to the reference, as known at that time
};

/// Current state of one camera.
struct CameraMotionState {
  CameraRotation
      turn; ///< rotation relative to the reference: the median over about the last second
  bool assessed = false; ///< true if the last image showed enough of the background
  bool moved =
      false; ///< true once reported; stays true until the camera is back or accept() is called
};

/// Detects camera motion during tracking. A few times per second, patches of the background are
/// located in each camera's images, and the camera rotation that most of them agree on is fitted.
/// Moving objects, shadows and occluded patches do not agree and are ignored. A rotation by more
/// than 0.05 degrees in half of the last checks is an event. A rotation of 0.1 degrees is reported
/// within about a second.
///
/// The first images received are the reference; they are assumed to match the calibration. Objects
/// that do not move for a long time gradually become part of the background. A camera whose image
/// has hardly any structure cannot be monitored (CameraMotionState::assessed).
class CameraMotionDetector {
public:
  explicit CameraMotionDetector(const CameraRig& rig);

  /// Checks the cameras that are due at the time of the frame set. Frame sets older than the
  /// previous one are ignored.
  void watch(const FrameSet& frames);

  /// Returns all events since the start.
  const std::vector<CameraMotionEvent>& events() const { return events_; }
  /// Returns the current state of a camera.
  const CameraMotionState& camera(std::size_t camera) const { return watched_[camera].state; }
  std::size_t cameraCount() const { return watched_.size(); }

  /// Accepts the current pose `now` of a camera. Its next images become the reference.
  void accept(std::size_t camera, const Camera& now);
  /// Makes the next images of all cameras the reference and discards the events.
  void restart();

private:
  struct TrackedPatch {
    BackgroundPatch patch;
    Eigen::Matrix<double, 2, 3> byTurn;
    Eigen::Vector3d initialTurn; ///< rotation of the camera when the piece was learned
    double lastSeen = 0.0;       ///< seconds
  };
  struct WatchedCamera {
    Camera camera;
    std::vector<TrackedPatch> pieces;
    std::deque<Eigen::Vector3d> turns; ///< results of the last checks
    double due = 0.0;                  ///< time of the next check, seconds
    double learned = 0.0;              ///< time of the last search for pieces, seconds
    int nextPart = 0;                  ///< part of the image to be searched for a piece next
    cv::Mat thumbnail;                 ///< thumbnail of the reference image, for large motions
    CameraMotionState state;
  };
  void check(std::size_t camera, const Frame& frame, const FrameSet& frames);
  /// Searches the next `parts` image parts without pieces for new pieces.
  static void learn(WatchedCamera& watched, const cv::Mat& image, double time,
                    const Eigen::Vector3d& turn, int parts);
  static std::optional<CameraRotation> measure(WatchedCamera& watched, const cv::Mat& image,
                                               double time, const Eigen::Vector3d& guess);
  static std::optional<Eigen::Vector3d> estimateLargeRotation(const WatchedCamera& watched,
                                                              const cv::Mat& image);
  void assess(std::size_t camera, const CameraRotation& turn, const FrameSet& frames);

  std::vector<WatchedCamera> watched_;
  std::vector<CameraMotionEvent> events_;
  double lastTime_ = -1e18;
};

} // namespace dewpoint::camera_motion
