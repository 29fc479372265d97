// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/capture/frame_source.h"
#include "core/session/run/frame_loop.h"
#include "core/session/watch/camera_agreement_watch.h"
#include "core/session/watch/camera_motion_observer.h"
#include "core/session/watch/camera_motion_watch.h"

#include <cstddef>
#include <string>
#include <vector>

namespace dewpoint::app {

/// Prints notes about a run in progress on stderr: notices from the source, cameras that have
/// moved, and cameras that contradict each other. Each note is printed once.
class RunNotes final : public FrameObserver {
public:
  /// Creates an observer of a run over the frames of `source`, which must outlive this object.
  RunNotes(const FrameSetSource& source, const CameraRig& rig)
      : source_(source), motionWatch_(rig), motionObserver_(motionWatch_),
        agreementWatch_(rig, motionWatch_) {}
  RunNotes(const RunNotes&) = delete;
  RunNotes& operator=(const RunNotes&) = delete;

  /// Prints new notices from the source. Call this while no frames arrive.
  void printNotices();
  void onFrameTaken(const FrameSet& /*frames*/) override { printNotices(); }
  Status onFrameTracked(const TrackingRun& run) override;

  /// Returns all notes printed so far.
  const std::vector<std::string>& printedNotes() const { return printed_; }

private:
  void print(std::string text);

  const FrameSetSource& source_;
  CameraMotionWatch motionWatch_;
  CameraMotionObserver motionObserver_;
  CameraAgreementWatch agreementWatch_;
  std::size_t printedMotions_ = 0;
  std::vector<CameraDisagreement> printedDisagreements_;
  std::vector<std::string> printed_;
};

} // namespace dewpoint::app
