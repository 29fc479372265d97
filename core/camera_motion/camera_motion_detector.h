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

/// Report that a camera has moved since its calibration.
struct CameraMotionEvent {
  std::size_t camera = 0;
  std::int64_t frame = 0; ///< frame in which the motion became certain
  TimeStamp time{};
  CameraRotation turn; ///< rotation since the reference, as known at that time
};

/// Current state of one camera.
struct CameraMotionState {
  CameraRotation turn;   ///< since the reference: the median over the last second or so
  bool assessed = false; ///< the last image showed enough of the background
  bool moved = false;    ///< reported; stays until the camera is back or accept()
};

/// Detects camera motion during tracking. Patches of the background are located again in each
/// camera's images a few times a second, and the camera rotation that most of them agree on is
/// fitted. Moving objects, shadows and occluded patches do not agree and are ignored. A rotation by
/// more than 0.05 degrees over half of the last checks is an event: one of 0.1 degrees is reported
/// within about a second.
///
/// The reference are the first images it is given; images are taken as of the calibrated cameras
/// then. What does not move for a long time becomes part of the background by and by. A camera
/// whose picture has hardly any structure cannot be watched (CameraMotionState::assessed).
class CameraMotionDetector {
public:
  explicit CameraMotionDetector(const CameraRig& rig);

  /// Checks the cameras that are due at the time of the frame set. Frame sets older than the last
  /// one are ignored.
  void watch(const FrameSet& frames);

  /// All events since the beginning.
  const std::vector<CameraMotionEvent>& events() const { return events_; }
  const CameraMotionState& camera(std::size_t camera) const { return watched_[camera].state; }
  std::size_t cameraCount() const { return watched_.size(); }

  /// Accepts the current pose `now` of a camera: its next images are the reference.
  void accept(std::size_t camera, const Camera& now);
  /// Makes the next images of all cameras the reference, and discards the events.
  void restart();

private:
  struct Piece {
    BackgroundPatch patch;
    Eigen::Matrix<double, 2, 3> byTurn;
    Eigen::Vector3d turnThen; ///< rotation of the camera when the piece was learned
    double lastSeen = 0.0;    ///< seconds
  };
  struct Watched {
    Camera camera;
    std::vector<Piece> pieces;
    std::deque<Eigen::Vector3d> turns; ///< results of the last checks
    double due = 0.0;                  ///< time of the next check, seconds
    double learned = 0.0;              ///< time of the last search for pieces, seconds
    int nextPart = 0;                  ///< part of the image to be searched for a piece next
    cv::Mat thumbnail;                 ///< of the reference image, for large motions
    CameraMotionState state;
  };
  void check(std::size_t camera, const Frame& frame, const FrameSet& frames);
  /// Searches for pieces in the next `parts` parts of the image that have none.
  static void learn(Watched& watched, const cv::Mat& image, double time,
                    const Eigen::Vector3d& turn, int parts);
  static std::optional<CameraRotation> measure(Watched& watched, const cv::Mat& image, double time,
                                               const Eigen::Vector3d& guess);
  static std::optional<Eigen::Vector3d> largeTurn(const Watched& watched, const cv::Mat& image);
  void assess(std::size_t camera, const CameraRotation& turn, const FrameSet& frames);

  std::vector<Watched> watched_;
  std::vector<CameraMotionEvent> events_;
  double lastTime_ = -1e18;
};

} // namespace dewpoint::camera_motion
