// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_times.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::capture {

/// Assigns the images of each camera of a recording to frame sets.
///
/// Frame set k belongs to the time k / rate. Without capture times, image k of a camera was
/// delivered at that time and shows the scene `delay` earlier. With capture times, the image
/// nearest in time belongs to the frame set; if it is more than half a frame away, the camera has
/// no image in the set. Frame set 0 is at the time when the last camera begins.
class CaptureSchedule {
public:
  /// Images of one camera.
  struct CameraPictures {
    std::int64_t count = 0; ///< number of images, > 0
    double delay = 0.0;     ///< seconds by which the images are delayed
    /// Capture times by a common clock, one for each image. Either all cameras have them or none.
    std::optional<CaptureTimes> times = std::nullopt;
    /// Where each picture stands among those that should be there, from 0 on, rising; empty: none
    /// is missing. Not used when there are times.
    std::vector<std::int64_t> sequenceNumbers = {};
  };
  /// `rate`: frame sets per second, > 0. `cameras`: at least one.
  CaptureSchedule(std::vector<CameraPictures> cameras, double rate);

  /// Number of frame sets, until the first camera ends. Each camera has an image in each of them,
  /// except where one is missing.
  std::int64_t frameCount() const { return count_; }

  /// Image of one camera in a frame set.
  struct Picture {
    std::int64_t number = 0; ///< index of the image
    double time = 0.0;       ///< capture time of the scene it shows, seconds since frame set 0
  };
  /// Image of a camera in a frame set; nothing if the camera has none.
  std::optional<Picture> pictureOf(std::size_t camera, std::int64_t frame) const;

  /// Number of frame sets that the images of a camera span, missing images included.
  static std::int64_t lengthOf(const CameraPictures& camera) {
    return camera.sequenceNumbers.empty() ? camera.count : camera.sequenceNumbers.back() + 1;
  }
  /// Rate in images per second from the capture times, that of the fastest camera; 0 if unknown.
  static double rateOf(const std::vector<CameraPictures>& cameras);

private:
  bool hasTimes() const { return cameras_.front().times.has_value(); }
  std::optional<Picture> byTime(const CameraPictures& camera, std::int64_t frame) const;

  std::vector<CameraPictures> cameras_;
  double rate_;
  double origin_ = 0.0; ///< of the capture times, seconds
  std::int64_t count_ = 0;
};

} // namespace dewpoint::capture
