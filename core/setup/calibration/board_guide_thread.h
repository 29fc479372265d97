// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/board_guide.h"

#include <functional>
#include <memory>

namespace dewpoint::setup {

/// Runs a BoardGuide in a separate thread on images from live cameras. Only the newest images are
/// processed. Every call returns immediately.
class BoardGuideThread {
public:
  /// `wake` is called from the guide's thread whenever newestState() returns a new state. It must
  /// do no more than post an event.
  explicit BoardGuideThread(std::function<void()> wake);
  /// Stops the thread. Do not call this from the thread of a window, because it waits until the
  /// images in progress are processed.
  ~BoardGuideThread();
  BoardGuideThread(const BoardGuideThread&) = delete;
  BoardGuideThread& operator=(const BoardGuideThread&) = delete;

  /// Starts the guided calibration of a project's cameras, or restarts it from scratch.
  void start(const Project& project, const BoardGuideRequest& request);
  /// Passes images to the guide, replacing images that are still waiting.
  void offer(FrameSetPtr frames);
  /// Captures the last images that show the board. Call this function when the user asks for it.
  void captureNow();
  /// Captures the last images that show the board, which must lie on the floor.
  void captureFloor();
  /// Ends the calibration of the intrinsics, whatever accuracy it has reached, and continues with
  /// the poses.
  void skipToPoses();
  /// Returns the newest state of the guided calibration since start(); never null.
  BoardGuideStatePtr newestState() const;

private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace dewpoint::setup
