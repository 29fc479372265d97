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

/// Report that a camera was moved after its calibration.
struct CameraMotionEvent {
  std::size_t camera = 0;
  std::int64_t frame = 0; ///< frame in which the motion became certain
  TimeStamp time{};
  CameraRotation
      rotation; ///< rotation relative to the reference images, as measured up to this frame
};

/// Whether one camera has moved, according to the latest checks.
struct CameraMotionState {
  /// Rotation relative to the reference images: the median over the last five checks (about one
  /// second).
  CameraRotation rotation;
  /// True if the last image that was checked showed enough of the background to measure the
  /// rotation.
  bool isAssessed = false;
  /// True after a motion was reported, until the camera is back in its old pose or
  /// acceptMovedCamera() is called.
  bool hasMoved = false;
};

/// Detects camera motion during tracking. Each camera is checked a few times per second. Patches of
/// the background are located in the image, and the camera rotation on which most patches agree is
/// fitted. Patches that do not agree are ignored, because they probably show moving objects or
/// shadows. A motion is reported if the median rotation of the last five checks is more than 0.05
/// degrees and clearly larger than its standard error. A rotation of 0.1 degrees is reported within
/// about a second.
///
/// The first images received are the reference images; they are assumed to match the calibration.
/// Objects that are at rest for a long time gradually become part of the background. A camera whose
/// image has hardly any structure cannot be monitored (CameraMotionState::isAssessed).
class CameraMotionDetector {
public:
  explicit CameraMotionDetector(const CameraRig& rig);

  /// Checks those cameras whose next check is due at the time of the frame set. A frame set that is
  /// not later than the previous frame set is ignored.
  void watch(const FrameSet& frames);

  /// Returns all motions reported since the start or the last restart().
  const std::vector<CameraMotionEvent>& events() const { return events_; }
  /// Returns whether a camera has moved, according to the latest checks.
  const CameraMotionState& camera(std::size_t camera) const { return watched_[camera].state; }
  std::size_t cameraCount() const { return watched_.size(); }

  /// Sets `now` as the calibration of a camera after it was moved. The next image of this camera
  /// becomes its reference image.
  void acceptMovedCamera(std::size_t camera, const Camera& now);
  /// Makes the next images of all cameras the reference images, and discards the events.
  void restart();

private:
  struct TrackedPatch {
    BackgroundPatch patch;
    Eigen::Matrix<double, 2, 3> shiftJacobian;
    Eigen::Vector3d initialRotation; ///< rotation of the camera when the patch was learned
    double lastSeenTime = 0.0;       ///< seconds
  };
  struct WatchedCamera {
    Camera camera;
    std::vector<TrackedPatch> patches;
    std::deque<Eigen::Vector3d> rotations; ///< rotations measured in the last checks
    double nextCheckTime = 0.0;            ///< time of the next check, seconds
    double lastPatchSearchTime = 0.0;      ///< time of the last search for new patches, seconds
    int nextImagePart = 0; ///< part of the image in which a patch is searched for next
    cv::Mat thumbnail;     ///< reduced reference image, for estimating large rotations
    CameraMotionState state;
  };
  void check(std::size_t camera, const Frame& frame, const FrameSet& frames);
  /// Searches for new patches in the next `parts` parts of the image that have no patch.
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
