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

/// One image of a live stream as it came, before it is decoded.
struct EncodedImage {
  std::shared_ptr<_GstSample> sample; ///< its bytes and their format
  CaptureInstant captured;
};

/// How much of a stream is kept in memory, to be written when a recording begins.
struct PreRollLimits {
  std::chrono::duration<double> length{0}; ///< time before the newest image; 0: nothing is kept
  std::size_t bytes = 0;                   ///< most memory; older images are dropped earlier
};

/// What a pre-roll contains.
struct PreRollStatus {
  double seconds = 0.0; ///< from the oldest to the newest image
  std::size_t images = 0;
  std::size_t bytes = 0;
  bool shortened = false; ///< images younger than the length were dropped for want of memory
};

/// The last images of one stream, copied out of the buffers of its driver. The oldest image stands
/// for itself: of H.264 and H.265 it is a key frame, so that a little more than the length is kept.
/// Images of an earlier format are dropped. For use by one thread at a time.
class PreRoll {
public:
  explicit PreRoll(const PreRollLimits& limits) : limits_(limits) {}

  void add(const EncodedImage& image);
  void clear();
  /// Returns the images, oldest first.
  const std::deque<EncodedImage>& images() const { return images_; }
  PreRollStatus status() const;

private:
  /// Drops the oldest image and those that need it.
  void dropFirstGroup();

  PreRollLimits limits_;
  std::deque<EncodedImage> images_;
  std::string format_; ///< of the images
  std::size_t bytes_ = 0;
  bool shortened_ = false;
};

} // namespace dewpoint::capture
