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

/// A camera that does not stand as it was calibrated any more.
struct CameraMotionEvent {
  std::size_t camera = 0;
  std::int64_t frame = 0; ///< in which it became certain
  TimeStamp time{};
  CameraRotation turn; ///< since the reference, as known then
};

/// What is known of one camera's direction now.
struct CameraMotionState {
  CameraRotation turn; ///< since the reference: the median over the last second or so
  bool judged = false; ///< the last image showed enough of the background
  bool moved = false;  ///< reported; stays until the camera is back or accept()
};

/// Watches, while tracking, whether a camera is moved: pieces of the background are found again in
/// each camera's images a few times a second, and the turn of the camera that most of them agree on
/// is fitted. Objects that move, shadows, and pieces that something covers do not agree and do not
/// count. A turn by more than 0.05 degrees over half of the last checks is an event: one of 0.1
/// degrees is reported within about a second.
///
/// The reference are the first images it is given; images are taken as of the calibrated cameras
/// then. What does not move for a long time becomes part of the background by and by. A camera
/// whose picture has hardly any structure cannot be watched (CameraMotionState::judged).
class CameraMotionDetector {
public:
  explicit CameraMotionDetector(const CameraRig& rig);

  /// Checks the cameras that are due at the frame set's time. Frame sets of the past are passed
  /// over.
  void watch(const FrameSet& frames);

  /// All since the beginning.
  const std::vector<CameraMotionEvent>& events() const { return events_; }
  const CameraMotionState& camera(std::size_t camera) const { return watched_[camera].state; }
  std::size_t cameraCount() const { return watched_.size(); }

  /// The camera as it stands now: its next images are the reference.
  void accept(std::size_t camera, const Camera& now);
  /// All cameras' next images are the reference; the events are forgotten.
  void restart();

private:
  struct Piece {
    BackgroundPatch patch;
    Eigen::Matrix<double, 2, 3> byTurn;
    Eigen::Vector3d turnThen; ///< the camera's, when the piece was learned
    double lastSeen = 0.0;    ///< seconds
  };
  struct Watched {
    Camera camera;
    std::vector<Piece> pieces;
    std::deque<Eigen::Vector3d> turns; ///< of the last checks
    double due = 0.0;                  ///< seconds
    double learned = 0.0;              ///< when pieces were last searched for, seconds
    int nextPart = 0;                  ///< of the image, the next to be searched for a piece
    cv::Mat thumbnail;                 ///< of the reference, for large motions
    CameraMotionState state;
  };
  void check(std::size_t camera, const Frame& frame, const FrameSet& frames);
  /// Looks for pieces in the next `parts` parts of the image that have none.
  static void learn(Watched& watched, const cv::Mat& image, double time,
                    const Eigen::Vector3d& turn, int parts);
  static std::optional<CameraRotation> measure(Watched& watched, const cv::Mat& image, double time,
                                               const Eigen::Vector3d& guess);
  static std::optional<Eigen::Vector3d> largeTurn(const Watched& watched, const cv::Mat& image);
  void judge(std::size_t camera, const CameraRotation& turn, const FrameSet& frames);

  std::vector<Watched> watched_;
  std::vector<CameraMotionEvent> events_;
  double lastTime_ = -1e18;
};

} // namespace dewpoint::camera_motion
