// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_instant.h"

#include <chrono>
#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <string>

struct _GstSample; // NOLINT(bugprone-reserved-identifier): the library's

namespace dewpoint::capture {

/// Image of a live stream before it is decoded.
struct EncodedImage {
  std::shared_ptr<_GstSample> sample; ///< bytes of the image and their format
  CaptureInstant captureInstant;
};

/// Limits of the images of a stream that are kept in memory and written when a recording begins.
struct PreRollLimits {
  /// Time before the newest image for which images are kept, seconds; 0: no images are kept.
  std::chrono::duration<double> duration{0};
  /// Maximum memory, bytes; if it is exceeded, the oldest images are dropped.
  std::size_t maxBytes = 0;
};

/// Number, duration and size of the latest images that a PreRoll keeps in memory.
struct PreRollStatus {
  double spanSeconds = 0.0;   ///< time from the oldest to the newest image, seconds
  std::size_t imageCount = 0; ///< number of images
  std::size_t byteCount = 0;
  /// True if images within PreRollLimits::duration were dropped because of the memory limit.
  bool isShortened = false;
};

/// Keeps copies of the latest images of one stream. The oldest image can be decoded without earlier
/// ones: for H.264 and H.265, it is a key frame. For this reason, a little more than
/// PreRollLimits::duration is kept. When the format of the images changes, all earlier images are
/// dropped. Not thread-safe.
class PreRoll {
public:
  explicit PreRoll(const PreRollLimits& limits) : limits_(limits) {}

  /// Adds a copy of an image, and drops images that are no longer needed.
  void add(const EncodedImage& image);
  /// Drops all images.
  void clear();
  /// Returns the images, oldest first.
  const std::deque<EncodedImage>& images() const { return images_; }
  PreRollStatus status() const;

private:
  /// Drops the oldest image and all images that cannot be decoded without it.
  void dropFirstGroup();

  PreRollLimits limits_;
  std::deque<EncodedImage> images_;
  std::string format_; ///< of the images
  std::size_t bytes_ = 0;
  bool shortened_ = false;
};

} // namespace dewpoint::capture
