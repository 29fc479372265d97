// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_times.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::capture {

/// Assigns the images of each camera in a recording to frame sets.
///
/// Frame set k is at time k / rate.
///
/// Without capture times, image k of a camera was delivered at time k / rate and shows the scene
/// `delay` seconds earlier. Each frame set gets the image that shows the scene closest to its time.
///
/// With capture times, each frame set gets the image with the closest capture time. If this time
/// differs from the time of the frame set by more than half a frame interval, the camera has no
/// image in the frame set. Frame set 0 is at the time of the first image of the camera that starts
/// last.
class CaptureSchedule {
public:
  /// Number, delay and capture times of the images of one camera.
  struct CameraImages {
    std::int64_t imageCount = 0; ///< number of images, > 0
    /// How much earlier an image shows the scene than its delivery or capture time says, seconds.
    double delay = 0.0;
    /// Capture time of each image, by a common clock. Either all cameras have capture times or
    /// none.
    std::optional<CaptureTimes> times = std::nullopt;
    /// Positions of the images in the complete sequence, ascending from 0. The complete sequence
    /// includes missing images. Empty if no image is missing. Not used if there are capture times.
    std::vector<std::int64_t> sequenceNumbers = {};
  };
  /// Creates the schedule for the images of `cameras` (at least one camera). `rate`: frame sets per
  /// second, > 0.
  CaptureSchedule(std::vector<CameraImages> cameras, double rate);

  /// Returns the number of frame sets. The last frame set contains the last image of the camera
  /// that ends first.
  std::int64_t frameCount() const { return count_; }

  /// One image of a camera, as assigned to a frame set.
  struct ScheduledImage {
    std::int64_t imageIndex = 0; ///< index of the image
    double time = 0.0; ///< time at which the image shows the scene, seconds after frame set 0
  };
  /// Returns the image of a camera in a frame set, or nothing if the camera has none.
  std::optional<ScheduledImage> imageAt(std::size_t camera, std::int64_t frame) const;

  /// Returns the number of frame sets spanned by the images of a camera, including missing images.
  static std::int64_t frameSetCountOf(const CameraImages& camera) {
    return camera.sequenceNumbers.empty() ? camera.imageCount : camera.sequenceNumbers.back() + 1;
  }
  /// Returns the highest frame rate of any camera in images per second, computed from the capture
  /// times; 0 if it is unknown.
  static double highestRateOf(const std::vector<CameraImages>& cameras);

private:
  bool hasTimes() const { return cameras_.front().times.has_value(); }
  std::optional<ScheduledImage> byTime(const CameraImages& camera, std::int64_t frame) const;

  std::vector<CameraImages> cameras_;
  double rate_;
  double origin_ = 0.0; ///< zero point of the capture times, seconds
  std::int64_t count_ = 0;
};

} // namespace dewpoint::capture
