// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/manual/moved_camera_pose.h"
#include "core/camera_motion/camera_motion_detector.h"
#include "core/camera_motion/reprojection_residuals.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::session {

/// Report of a moved camera, for views and messages.
struct CameraMotionReport {
  CameraMotionEvent event;
  bool isBackInPose = false; ///< the camera is back in its former pose
  /// Recent distance, in pixels of this camera's image, between targets and their positions
  /// according to the other cameras; empty if unknown.
  std::optional<double> targetDistancePx;
  /// Current pose of the camera, which can replace the pose in the project; empty if unknown. It is
  /// computed about once a second from the measured rotation and from the tracked targets that the
  /// camera has seen since the motion.
  std::optional<MovedCameraPose> newPose;
};

/// Detects during a run which cameras have moved (CameraMotionDetector). For each moved camera, it
/// also computes a new pose, and how far targets in its image are from their positions according to
/// the other cameras.
class CameraMotionWatch {
public:
  explicit CameraMotionWatch(const CameraRig& rig);

  /// Searches the images of a frame for camera motions. Call this after all iterations of the
  /// frame, whose estimates are `estimates`.
  void watch(const FrameSet& frames, const std::vector<Target>& targets,
             const std::vector<SphereEstimate>& estimates);
  /// Pauses or resumes the detection. It must be paused while a calibration board is shown to live
  /// cameras, because a moving board can look like a rotation of the camera. After the pause, each
  /// camera without a report is assumed to be in its calibrated pose, and its image becomes the new
  /// reference.
  void setPaused(bool paused);
  const std::vector<CameraMotionReport>& reports() const { return reports_; }
  /// Returns one notice for each report: which camera has moved, how far, and when.
  std::vector<Error> notices() const;
  /// Replaces the calibrations of the cameras. A camera whose calibration changed is assumed to be
  /// in the new pose and is no longer reported.
  void setCameras(const CameraRig& rig);
  /// Starts from scratch for a restarted run: assumes that all cameras are in their calibrated
  /// poses and discards all measurements. Motions that a new calibration already includes are
  /// remembered, so that they are not reported again.
  void restart();

private:
  void update(CameraMotionReport& report, double time);
  /// Returns whether the calibration is the one made after this motion.
  bool isSolved(const CameraMotionEvent& event) const;

  CameraRig rig_;
  CameraMotionDetector detector_;
  ReprojectionResiduals sightings_;
  /// For each camera: frame of the motion after which its calibration was made; empty if there is
  /// none.
  std::vector<std::optional<std::int64_t>> solvedAt_;
  std::size_t eventsSeen_ = 0;
  std::vector<CameraMotionReport> reports_;
  double due_ = 0.0; ///< seconds; time for work that is not done in every frame
  double lastTime_ = -1e18;
  bool paused_ = false;
  bool resumed_ = false;      ///< the pause has ended and no frame has arrived since
  double resumeTime_ = -1e18; ///< seconds
};

/// Returns the new pose of a camera that has moved, computed from its measured rotation `turn` and
/// from the targets that it has seen (`sightings`) at or after the time `since` (seconds). Returns
/// an error if the rotation and the sightings do not determine the pose.
Result<MovedCameraPose> estimatePoseAfterMotion(const Camera& camera, const CameraRotation& turn,
                                                const std::deque<ReprojectionResidual>& sightings,
                                                double since);

} // namespace dewpoint::session
