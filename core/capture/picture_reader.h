// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/recording.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// The pictures of one recorded camera by number, as stored: not yet turned, size not yet checked.
class PictureReader {
public:
  virtual ~PictureReader() = default;
  virtual std::int64_t frameCount() const = 0;
  /// The recording's own rate; 0 when it has none.
  virtual double framesPerSecond() const { return 0; }
  /// Picture number `frame`; an empty picture at an end that is no error. The pixels are the
  /// caller's own. Fast when the numbers rise one by one.
  virtual Result<cv::Mat> read(std::int64_t frame) = 0;
  /// The file that picture comes from, for errors.
  virtual std::string fileOf(std::int64_t frame) const = 0;
};

using PictureReaderPtr = std::unique_ptr<PictureReader>;

/// Whether a file is a picture, by the ending of its name.
bool isPictureFile(const std::string& path);

/// `field` names the camera in errors.
Result<PictureReaderPtr> openVideoReader(const std::string& path, const std::string& field);
Result<PictureReaderPtr> openImageReader(const std::string& folder, const std::string& field);
/// One picture.
Result<PictureReaderPtr> openPictureReader(const std::string& file, const std::string& field);
Result<PictureReaderPtr> openGeneratedReader(const RecordedCamera& camera,
                                             const std::string& field);

/// Whether `left` comes before `right` when numbers inside names count as numbers ("2" < "10").
bool naturallyBefore(const std::string& left, const std::string& right);

} // namespace dewpoint::capture
