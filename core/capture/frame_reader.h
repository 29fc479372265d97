// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Reads images of one recorded camera by number. The images are returned as stored: they are not
/// rotated, and their size is not checked.
class FrameReader {
public:
  virtual ~FrameReader() = default;
  /// Returns the number of images in the recording.
  virtual std::int64_t frameCount() const = 0;
  /// Returns the frame rate of the recording in frames per second, or 0 if the recording does not
  /// specify it.
  virtual double framesPerSecond() const { return 0; }
  /// Reads image number `frame`. Returns an empty image after the last image of the recording. The
  /// caller owns the pixels. Reading is fast if the numbers increase one by one.
  virtual Result<cv::Mat> read(std::int64_t frame) = 0;
  /// Returns the positions of the images in the complete sequence, ascending from 0. The complete
  /// sequence includes missing images. The result is empty if no image is missing.
  virtual std::vector<std::int64_t> sequenceNumbers() const { return {}; }
  /// Returns the file that contains an image, for error messages.
  virtual std::string fileOf(std::int64_t frame) const = 0;
};

using FrameReaderPtr = std::unique_ptr<FrameReader>;

} // namespace dewpoint::capture
