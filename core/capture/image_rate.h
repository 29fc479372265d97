// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <chrono>

namespace dewpoint::capture {

/// Smoothed rate of the images of one camera. A single long pause between two images does not
/// change the rate, because the camera may have frozen for a moment. A second long pause in a row
/// changes the rate, because the camera has then become slow. Not thread-safe.
class ImageRate {
public:
  using Clock = std::chrono::steady_clock;

  /// Counts an image that arrived at `time`.
  void add(Clock::time_point time);
  /// Forgets when the last image arrived, but not the rate. Call this after a new connection.
  void restart();
  /// Returns the rate in images per second; 0 before the second image.
  double imagesPerSecond() const { return interval_ > 0.0 ? 1.0 / interval_ : 0.0; }

private:
  double interval_ = 0.0; ///< smoothed time between two images, seconds; 0: unknown
  bool isPaused_ = false; ///< the last interval was a pause
  Clock::time_point last_{};
  bool hasLast_ = false;
};

} // namespace dewpoint::capture
