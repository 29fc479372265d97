// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/time.h"
#include "core/capture/capture_instant.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace dewpoint::capture {

/// One image from one camera. The frame owns its pixels, which must not be modified after the frame
/// is published.
struct Frame {
  std::int64_t index = 0;  ///< frame number of this camera, from 0
  TimeStamp captureTime{}; ///< capture time by the camera's own clock
  cv::Mat image;           ///< CV_8UC3 (blue, green, red)
  /// Source of the capture time of a live image (driver, sender or arrival); not used for
  /// recordings.
  TimeOrigin origin = TimeOrigin::Arrival;
  LiveInstants instants{}; ///< processing times of a live image; all zero for recordings
};
using FramePtr = std::shared_ptr<const Frame>;

/// Images of all cameras at one time. `frames` has one entry per camera of the rig, in the same
/// order; the entry is null if the camera has no image.
struct FrameSet {
  std::int64_t index = 0;
  TimeStamp time{};
  std::vector<FramePtr> frames;
};
using FrameSetPtr = std::shared_ptr<const FrameSet>;

} // namespace dewpoint::capture
