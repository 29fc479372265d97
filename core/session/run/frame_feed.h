// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/tracking_run.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace dewpoint::session {

/// Tracks images that the calling program supplies, one frame at a time. The results are
/// bit-identical to those of a recording with the same images and times. Used by one thread at a
/// time.
class FrameFeed {
public:
  /// Creates a feed for the cameras of a project, without opening the project's own videos or
  /// cameras. Returns the errors of checkProject(), checkMethodTargets(), loadBackgroundImages()
  /// and TrackingRun::create().
  static Result<FrameFeed> create(const Project& project, int threads);

  /// Tracks one frame, captured at `time` (seconds), which must be later than the time of the frame
  /// before. `images` has one image per camera in project order: CV_8UC3 (blue, green, red), of the
  /// size in the calibration, or empty for a camera without an image. The images are not copied, so
  /// their pixels must not be changed afterward. Returns BadValue, which names "images" or "time",
  /// if an argument is wrong; nothing has changed then.
  Status step(const std::vector<cv::Mat>& images, double time);

  /// Return the current estimates of all targets: samples() positions in the room or, for methods
  /// that track boxes, boxSamples() bounding boxes in the images. Empty before the first step.
  std::vector<TrajectorySample> samples() const { return run_.samples(); }
  std::vector<BoxSample> boxSamples() const { return run_.boxSamples(); }
  const TrackingRun& run() const { return run_; }
  std::int64_t stepCount() const { return steps_; }
  /// Restarts from scratch. The time of the next frame may then be earlier.
  void restart();

private:
  explicit FrameFeed(TrackingRun run) : run_(std::move(run)) {}
  Status checkImages(const std::vector<cv::Mat>& images) const;

  TrackingRun run_;
  std::int64_t steps_ = 0;
  double time_ = -std::numeric_limits<double>::infinity();
};

} // namespace dewpoint::session
