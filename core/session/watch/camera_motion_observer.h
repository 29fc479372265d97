// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/frame_loop.h"
#include "core/session/watch/camera_motion_watch.h"

namespace dewpoint::session {

/// Passes the frames of a run to a CameraMotionWatch. Does nothing for methods that track boxes,
/// whose camera may move.
class CameraMotionObserver final : public FrameObserver {
public:
  /// Creates an observer that passes frames to `watch`, which must outlive this object.
  explicit CameraMotionObserver(CameraMotionWatch& watch) : watch_(watch) {}

  Status onFrameTracked(const TrackingRun& run) override {
    if (run.definition()->family().needsCalibration) {
      watch_.watch(*run.frames(), run.targets(), spheresOf(run.estimates()));
    }
    return {};
  }

private:
  CameraMotionWatch& watch_;
};

} // namespace dewpoint::session
