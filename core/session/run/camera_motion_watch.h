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

/// A camera that was moved, as views and reports show it.
struct CameraMotionReport {
  CameraMotionEvent event;
  bool back = false; ///< the camera stands as before again
  /// How far the target is beside where the other cameras see it, since the camera moved; pixels.
  std::optional<double> targetPixels;
  /// The camera as it stands now, to be put into the project: by the turn that was measured, and by
  /// the tracked targets' sightings since then. Recomputed about once a second.
  std::optional<MovedCameraPose> newPose;
};

/// Watches during a run whether cameras are moved (CameraMotionDetector), and how far the targets
/// are beside where the other cameras see them. What a moved camera would have to be calibrated to
/// is kept ready.
class CameraMotionWatch {
public:
  explicit CameraMotionWatch(const CameraRig& rig);

  /// After the iterations of a frame.
  void watch(const FrameSet& frames, const std::vector<Target>& targets,
             const std::vector<SphereEstimate>& estimates);
  /// While a calibration board is shown to live cameras nothing is watched: the image of a moving
  /// board that fills it is like that of a scene before a rotating camera, and so is that of a
  /// board that was there when the reference was taken. Afterwards, as soon as the board has been
  /// put down, the cameras that are not reported stand as they are calibrated, and their images are
  /// the reference.
  void setResting(bool resting);
  const std::vector<CameraMotionReport>& reports() const { return reports_; }
  /// One for each report: which camera, by how much, when.
  std::vector<Error> notices() const;
  /// Other calibrations of the same cameras: those that changed stand as they are said to stand
  /// from now on, and are not reported any more.
  void setCameras(const CameraRig& rig);
  /// The cameras stand as they are calibrated; what was known is forgotten, but for the motions
  /// that a new calibration has taken in: a recording that is played again shows the same.
  void restart();

private:
  void update(CameraMotionReport& report, double time);
  /// Whether the calibration is that after this very motion.
  bool isSolved(const CameraMotionEvent& event) const;

  CameraRig rig_;
  CameraMotionDetector detector_;
  ReprojectionResiduals sightings_;
  std::vector<std::optional<std::int64_t>> solvedAt_; ///< per camera, frame of a motion taken in
  std::size_t eventsSeen_ = 0;
  std::vector<CameraMotionReport> reports_;
  double due_ = 0.0; ///< seconds; of what is not done in each frame
  double lastTime_ = -1e18;
  bool resting_ = false;
  bool wokenUp_ = false;     ///< and no frame has come since
  double awakeFrom_ = -1e18; ///< seconds
};

/// The pose of a camera that was moved at `event`, from the rotation known now and the sightings
/// since.
Result<MovedCameraPose> estimatePoseAfterMotion(const Camera& camera, const CameraRotation& turn,
                                                const std::deque<ReprojectionResidual>& sightings,
                                                double since);

} // namespace dewpoint::session
