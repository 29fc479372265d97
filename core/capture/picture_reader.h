// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Reads the images of one recorded camera by number, as stored: not yet rotated, size not yet
/// checked.
class PictureReader {
public:
  virtual ~PictureReader() = default;
  virtual std::int64_t frameCount() const = 0;
  /// Frame rate of the recording, in frames per second; 0 if it states none.
  virtual double framesPerSecond() const { return 0; }
  /// Reads image number `frame`; an empty image at an end that is not an error. The caller owns the
  /// pixels. Fast when the numbers rise one by one.
  virtual Result<cv::Mat> read(std::int64_t frame) = 0;
  /// Where each picture stands among those that should be there, from 0 on, rising, when some are
  /// missing; empty: none is.
  virtual std::vector<std::int64_t> sequenceNumbers() const { return {}; }
  /// The file that picture comes from, for errors.
  virtual std::string fileOf(std::int64_t frame) const = 0;
};

using PictureReaderPtr = std::unique_ptr<PictureReader>;

} // namespace dewpoint::capture
