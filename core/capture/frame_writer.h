// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace cv {
class VideoWriter;
}

namespace dewpoint::capture {

/// Writes one camera's pictures without loss, so that reading them back gives the same bytes.
class FrameWriter {
public:
  /// A folder of PNG files 000000.png, 000001.png, ...; made when it does not exist.
  static Result<FrameWriter> images(const std::string& folder);
  /// An FFV1 video; the file name should end in .mkv. The first picture sets the size.
  static Result<FrameWriter> video(const std::string& file, double framesPerSecond);

  FrameWriter(FrameWriter&&) noexcept;
  FrameWriter& operator=(FrameWriter&&) noexcept;
  ~FrameWriter();

  /// `image` is CV_8UC3, blue green red, all of one size.
  Status write(const cv::Mat& image);
  /// Closes the output and checks that it is there. Writing afterwards fails.
  Status finish();
  std::int64_t framesWritten() const { return frames_; }

private:
  FrameWriter();
  Status writeImage(const cv::Mat& image);
  Status writeVideo(const cv::Mat& image);

  std::string path_;
  double framesPerSecond_ = 0; ///< 0: a folder of pictures
  std::unique_ptr<cv::VideoWriter> video_;
  cv::Size size_;
  std::int64_t frames_ = 0;
  bool finished_ = false;
};

} // namespace dewpoint::capture
