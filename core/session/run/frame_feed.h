// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/tracking_run.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace dewpoint::session {

/// Tracks the images of a program that reads its cameras itself, one instant after the other. The
/// same images at the same times give the same bits as a recording of them. Used by one thread at a
/// time.
class FrameFeed {
public:
  /// For the cameras of a project, whose own sources are not opened. Errors of checkProject(),
  /// checkMethodTargets(), loadEmptyRooms() and TrackingRun::create().
  static Result<FrameFeed> create(const Project& project, int threads);

  /// Tracks one instant, `time` in seconds. `images`: one per camera in the order of the project,
  /// CV_8UC3 (blue green red) of the size in the calibration, empty where that camera has none.
  /// They are kept for a while, not copied: nobody may write their pixels any more.
  /// BadValue names "images" or "time" (which has to rise), and nothing has changed.
  Status step(const std::vector<cv::Mat>& images, double time);

  /// What is believed now of all targets: in the room, or in the images for methods that follow
  /// boxes. Empty before the first step.
  std::vector<TrajectorySample> samples() const { return run_.samples(); }
  std::vector<BoxSample> boxes() const { return run_.boxSamples(); }
  const TrackingRun& run() const { return run_; }
  std::int64_t steps() const { return steps_; }
  /// Forgets everything; time may begin again.
  void restart();

private:
  explicit FrameFeed(TrackingRun run) : run_(std::move(run)) {}
  Status checkImages(const std::vector<cv::Mat>& images) const;

  TrackingRun run_;
  std::int64_t steps_ = 0;
  double time_ = -std::numeric_limits<double>::infinity();
};

} // namespace dewpoint::session
