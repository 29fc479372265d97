// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_times.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::capture {

/// Which picture of each camera of a recording belongs to each frame set.
///
/// Frame set k is of the time k / rate. Without times, picture k of a camera was taken then, or
/// shows what was `delay` before. With times, the picture nearest to it belongs to the set, unless
/// it is farther than half a frame: then the camera has none. Set 0 is when the last camera begins.
class CaptureSchedule {
public:
  struct CameraPictures {
    std::int64_t count = 0; ///< > 0
    double delay = 0.0;     ///< seconds by which they are late
    /// By a common clock, one for each picture; all cameras have them or none.
    std::optional<CaptureTimes> times = std::nullopt;
    /// Where each picture stands among those that should be there, from 0 on, rising; empty: none
    /// is missing. Not used when there are times.
    std::vector<std::int64_t> places = {};
  };
  /// `rate` > 0: frame sets per second. At least one camera.
  CaptureSchedule(std::vector<CameraPictures> cameras, double rate);

  /// Frame sets of which every camera has a picture, or should: until the first camera ends.
  std::int64_t frameCount() const { return count_; }

  struct Picture {
    std::int64_t number = 0;
    double time = 0.0; ///< when what it shows was, seconds since frame set 0
  };
  /// The picture of a camera in a frame set; nothing where there is none.
  std::optional<Picture> pictureOf(std::size_t camera, std::int64_t frame) const;

  /// Frame sets that so many pictures last, with those that are missing.
  static std::int64_t lengthOf(const CameraPictures& camera) {
    return camera.places.empty() ? camera.count : camera.places.back() + 1;
  }
  /// Pictures per second by their times: of the camera that takes most. 0: unknown.
  static double rateOf(const std::vector<CameraPictures>& cameras);

private:
  bool hasTimes() const { return cameras_.front().times.has_value(); }
  std::optional<Picture> byTime(const CameraPictures& camera, std::int64_t frame) const;

  std::vector<CameraPictures> cameras_;
  double rate_;
  double origin_ = 0.0; ///< of the times, seconds
  std::int64_t count_ = 0;
};

} // namespace dewpoint::capture
