// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/frame_writer.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include <cmath>
#include <filesystem>

namespace dewpoint::capture {

namespace fs = std::filesystem;

FrameWriter::FrameWriter() = default;
FrameWriter::FrameWriter(FrameWriter&&) noexcept = default;
FrameWriter& FrameWriter::operator=(FrameWriter&&) noexcept = default;
FrameWriter::~FrameWriter() = default;

Result<FrameWriter> FrameWriter::createImageFolder(const std::string& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem || !fs::is_directory(folder, problem)) {
    return failure(ErrorCode::FileUnwritable, folder, "",
                   problem ? problem.message() : "it is not a folder");
  }
  FrameWriter writer;
  writer.path_ = folder;
  return writer;
}

Result<FrameWriter> FrameWriter::createVideo(const std::string& file, double framesPerSecond) {
  if (!std::isfinite(framesPerSecond) || framesPerSecond <= 0) {
    return failure(ErrorCode::BadValue, file, "frames per second",
                   fmt::format("{} is not a valid frame rate", framesPerSecond));
  }
  std::error_code problem;
  const fs::path folder = fs::absolute(file, problem).parent_path();
  fs::create_directories(folder, problem);
  if (problem) {
    return failure(ErrorCode::FileUnwritable, file, "", problem.message());
  }
  FrameWriter writer;
  writer.path_ = file;
  writer.framesPerSecond_ = framesPerSecond;
  return writer;
}

Status FrameWriter::write(const cv::Mat& image) {
  if (finished_) {
    return failure(ErrorCode::FileUnwritable, path_, "", "it is already closed");
  }
  if (image.empty() || image.type() != CV_8UC3) {
    return failure(ErrorCode::BadValue, path_, "", "an image must have three 8-bit channels");
  }
  if (frames_ > 0 && image.size() != size_) {
    return failure(ErrorCode::Mismatch, path_, "",
                   fmt::format("image {} is {} x {}, but the first was {} x {}", frames_,
                               image.cols, image.rows, size_.width, size_.height));
  }
  size_ = image.size();
  try {
    const Status written = framesPerSecond_ > 0 ? writeVideo(image) : writeImage(image);
    frames_ += written ? 1 : 0;
    return written;
  } catch (const std::exception& problem) {
    return failure(ErrorCode::FileUnwritable, path_, "", problem.what());
  }
}

Status FrameWriter::writeImage(const cv::Mat& image) {
  const std::string file = (fs::path(path_) / fmt::format("{:06}.png", frames_)).string();
  if (!cv::imwrite(file, image)) {
    return failure(ErrorCode::FileUnwritable, file, "", "");
  }
  return {};
}

Status FrameWriter::writeVideo(const cv::Mat& image) {
  if (!video_) {
    auto video = std::make_unique<cv::VideoWriter>();
    const int codec = cv::VideoWriter::fourcc('F', 'F', 'V', '1');
    if (!video->open(fs::absolute(path_).string(), cv::CAP_FFMPEG, codec, framesPerSecond_,
                     image.size())) {
      return failure(ErrorCode::FileUnwritable, path_, "", "the FFV1 video cannot be opened");
    }
    video_ = std::move(video);
  }
  video_->write(image);
  return {};
}

Status FrameWriter::finish() {
  if (finished_) {
    return {};
  }
  finished_ = true;
  if (!video_) {
    return {};
  }
  try {
    video_.reset();
    // The encoder does not report a full disk; a video that cannot be read back tells.
    cv::VideoCapture check(fs::absolute(path_).string(), cv::CAP_FFMPEG);
    const double announced = check.isOpened() ? check.get(cv::CAP_PROP_FRAME_COUNT) : 0;
    // The container stores the duration, not the count: one frame either way is rounding.
    if (std::abs(announced - static_cast<double>(frames_)) > 1.5) {
      return failure(ErrorCode::FileUnwritable, path_, "",
                     "the video is incomplete; the disk may be full");
    }
  } catch (const std::exception& problem) {
    return failure(ErrorCode::FileUnwritable, path_, "", problem.what());
  }
  return {};
}

} // namespace dewpoint::capture
