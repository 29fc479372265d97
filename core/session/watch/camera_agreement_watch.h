// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/camera_agreement.h"
#include "core/session/run/frame_loop.h"
#include "core/session/watch/camera_motion_watch.h"

#include <vector>

namespace dewpoint::session {

/// Checks during a run whether the cameras agree with each other (CameraAgreement). Does nothing
/// for methods that track boxes, whose cameras need no calibration.
class CameraAgreementWatch final : public FrameObserver {
public:
  /// Creates a watch for the cameras of `rig`. A fault is not reported if a camera that `motion`
  /// reports as moved may explain it. `motion` must outlive this object.
  CameraAgreementWatch(const CameraRig& rig, const CameraMotionWatch& motion)
      : agreement_(rig), motion_(motion) {}

  Status onFrameTracked(const TrackingRun& run) override;

  /// Returns the faults of the cameras found so far (CameraAgreement::disagreements()); none for a
  /// method that needs no calibration.
  std::vector<CameraDisagreement> disagreements(const MethodFamily& family) const;

  /// Replaces the calibrations of the cameras and starts the assessment from scratch.
  void setCameras(const CameraRig& rig) { agreement_ = CameraAgreement(rig); }
  /// Pauses or resumes the check. The check is paused while a calibration board is shown to live
  /// cameras.
  void setPaused(bool paused) { paused_ = paused; }
  /// Discards all measurements, for a restart of the run.
  void restart() { agreement_.restart(); }

private:
  CameraAgreement agreement_;
  const CameraMotionWatch& motion_;
  bool paused_ = false;
};

} // namespace dewpoint::session
