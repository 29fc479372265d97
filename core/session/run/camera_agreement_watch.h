// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/camera_agreement.h"
#include "core/session/run/camera_motion_watch.h"
#include "core/session/run/frame_loop.h"

#include <vector>

namespace dewpoint::session {

/// Watches during a run whether its cameras can agree (CameraAgreement); nothing where boxes are
/// followed, whose cameras need no calibration.
class CameraAgreementWatch final : public FrameObserver {
public:
  /// A camera of which `motion` reports that it was moved is not reported for it here. It must
  /// outlive this.
  CameraAgreementWatch(const CameraRig& rig, const CameraMotionWatch& motion)
      : agreement_(rig), motion_(motion) {}

  Status tracked(const TrackingRun& run) override;

  /// What is wrong, as far as it is known (CameraAgreement::found()); nothing for a method that
  /// needs no calibration.
  std::vector<CameraDisagreement> found(const MethodFamily& family) const;

  /// Other calibrations of the same cameras: what was seen is looked at again.
  void setCameras(const CameraRig& rig) { agreement_ = CameraAgreement(rig); }
  /// While a calibration board is shown to live cameras nothing is watched.
  void setResting(bool resting) { resting_ = resting; }
  /// Forgets what was seen.
  void restart() { agreement_.restart(); }

private:
  CameraAgreement agreement_;
  const CameraMotionWatch& motion_;
  bool resting_ = false;
};

} // namespace dewpoint::session
