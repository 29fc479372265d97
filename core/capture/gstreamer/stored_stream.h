// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/gstreamer/gst_library.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <filesystem>
#include <string>

namespace dewpoint::capture {

/// Reads the video of a StreamRecording with the same decoders as a live camera (GstStream). An
/// image that was stored unchanged therefore has exactly the same pixels as the live image. With
/// decoders of other libraries, pixels may differ by one or two gray levels. For use by one thread
/// only.
class StoredStream {
public:
  /// Opens a video. `field` names the camera in errors. Errors: FileMissing, FileUnreadable.
  static Result<StoredStream> open(const std::filesystem::path& video, const std::string& field);

  /// Returns image `number` as CV_8UC3 (blue, green, red). Numbers count from 0 and must increase
  /// from call to call. Error: EndedEarly if the video has no such image, or if the image cannot be
  /// decoded.
  Result<cv::Mat> read(std::int64_t number);

private:
  StoredStream(GstElementPtr pipeline, std::filesystem::path video, std::string field);

  GstElementPtr pipeline_;
  _GstElement* sink_ = nullptr; ///< in the pipeline
  std::filesystem::path video_;
  std::string field_;
  std::int64_t next_ = 0; ///< number of the image that comes next
};

} // namespace dewpoint::capture
