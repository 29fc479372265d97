// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/watch/camera_agreement_watch.h"
#include "core/session/watch/camera_motion_observer.h"

namespace dewpoint::session {

/// Checks during a run whether a camera has moved, and whether the cameras agree with each other.
class CameraWatches final : public FrameObserver {
public:
  /// Creates the checks for cameras whose calibration at the start of the run is `rig`.
  explicit CameraWatches(const CameraRig& rig) : motion_(rig), agreement_(rig, motion_) {}
  CameraWatches(const CameraWatches&) = delete;
  CameraWatches& operator=(const CameraWatches&) = delete;

  Status onFrameTracked(const TrackingRun& run) override {
    return motionObserver_.onFrameTracked(run).and_then(
        [&] { return agreement_.onFrameTracked(run); });
  }

  const CameraMotionWatch& motionWatch() const { return motion_; }
  const CameraAgreementWatch& agreementWatch() const { return agreement_; }
  /// Replaces the calibrations of the cameras.
  void setCameras(const CameraRig& rig) {
    motion_.setCameras(rig);
    agreement_.setCameras(rig);
  }
  /// Pauses or resumes the checks. They are paused while a calibration board is shown to live
  /// cameras.
  void setPaused(bool paused) {
    motion_.setPaused(paused);
    agreement_.setPaused(paused);
  }
  /// Discards all measurements of both checks, for a restart of the run.
  void restart() {
    motion_.restart();
    agreement_.restart();
  }

private:
  CameraMotionWatch motion_;
  CameraMotionObserver motionObserver_{motion_};
  CameraAgreementWatch agreement_;
};

} // namespace dewpoint::session
