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

/// Writes the images of one camera without loss: reading them back returns the same pixels.
class FrameWriter {
public:
  /// Creates a writer for a folder of PNG files 000000.png, 000001.png, ... The folder is created
  /// if needed.
  static Result<FrameWriter> createImageFolder(const std::string& folder);
  /// Creates a writer for an FFV1 video; the file name should end in .mkv. The first image
  /// determines the size.
  static Result<FrameWriter> createVideo(const std::string& file, double framesPerSecond);

  FrameWriter(FrameWriter&&) noexcept;
  FrameWriter& operator=(FrameWriter&&) noexcept;
  ~FrameWriter();

  /// Writes one image: CV_8UC3 (blue, green, red). All images must have the same size.
  Status write(const cv::Mat& image);
  /// Closes the output and checks that it exists. Later writes fail.
  Status finish();
  std::int64_t writtenFrameCount() const { return frames_; }

private:
  FrameWriter();
  Status writeImage(const cv::Mat& image);
  Status writeVideo(const cv::Mat& image);

  std::string path_;
  double framesPerSecond_ = 0; ///< 0 if writing a folder of images
  std::unique_ptr<cv::VideoWriter> video_;
  cv::Size size_;
  std::int64_t frames_ = 0;
  bool finished_ = false;
};

} // namespace dewpoint::capture
