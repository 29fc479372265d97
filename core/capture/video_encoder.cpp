// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/video_encoder.h"

#include "core/base/growing_file.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <utility>

namespace dewpoint::capture {
namespace {

namespace fs = std::filesystem;

constexpr int kProbeFrames = 3;
constexpr int kProbeWidth = 160; ///< pixels
constexpr int kProbeHeight = 120;

constexpr std::array kVideoEncodings{
    VideoEncoding{"h264", ".mp4", "avc1"},
    VideoEncoding{"vp8", ".webm", "VP80"},
    VideoEncoding{"mjpeg", ".avi", "MJPG"},
    VideoEncoding{"ffv1", ".mkv", "FFV1"},
};

Status checkOutput(const VideoOutput& output) {
  const std::string file = output.file.string();
  if (!std::isfinite(output.framesPerSecond) || output.framesPerSecond <= 0.0) {
    return failure(ErrorCode::BadValue, file, "frames per second",
                   fmt::format("{} is not a valid frame rate", output.framesPerSecond));
  }
  if (output.width <= 0 || output.height <= 0 || output.width % 2 != 0 || output.height % 2 != 0) {
    return failure(ErrorCode::BadValue, file, "size",
                   fmt::format("{} x {} is not a valid size: width and height must be even",
                               output.width, output.height));
  }
  return {};
}

/// Beside the file, with its suffix, by which the container is chosen.
fs::path temporaryFileOf(const fs::path& file) {
  return file.parent_path() / (file.stem().string() + ".part" + file.extension().string());
}

Result<std::unique_ptr<cv::VideoWriter>> openVideo(const VideoOutput& output,
                                                   const fs::path& part) {
  const std::string_view codec = output.encoding.codec;
  if (codec.size() != 4) {
    return failure(ErrorCode::BadValue, output.file.string(), "encoding",
                   fmt::format("\"{}\" is not a known encoding", output.encoding.id));
  }
  try {
    auto video = std::make_unique<cv::VideoWriter>();
    const int code = cv::VideoWriter::fourcc(codec[0], codec[1], codec[2], codec[3]);
    if (video->open(part.string(), cv::CAP_FFMPEG, code, output.framesPerSecond,
                    cv::Size(output.width, output.height))) {
      return video;
    }
  } catch (const std::exception& problem) {
    return failure(ErrorCode::FileUnwritable, output.file.string(), "", problem.what());
  }
  return failure(ErrorCode::FileUnwritable, output.file.string(), "",
                 fmt::format("this computer has no encoder \"{}\" for {}", output.encoding.id,
                             output.encoding.suffix));
}

bool isWritable(const VideoEncoding& encoding, const fs::path& folder) {
  VideoOutput output;
  output.file = folder / (std::string("probe") + std::string(encoding.suffix));
  output.encoding = encoding;
  output.width = kProbeWidth;
  output.height = kProbeHeight;
  bool isWritten = false;
  if (auto encoder = VideoEncoder::create(output)) {
    isWritten = true;
    const cv::Mat gray(kProbeHeight, kProbeWidth, CV_8UC3, cv::Scalar::all(128));
    for (int frame = 0; isWritten && frame < kProbeFrames; ++frame) {
      isWritten = encoder->write(gray).has_value();
    }
    isWritten = isWritten && encoder->finish();
  }
  std::error_code ignored;
  fs::remove(output.file, ignored);
  return isWritten;
}

} // namespace

std::span<const VideoEncoding> videoEncodings() {
  return kVideoEncodings;
}

std::vector<VideoEncoding> writableVideoEncodings(const fs::path& folder) {
  std::vector<VideoEncoding> writable;
  for (const VideoEncoding& encoding : kVideoEncodings) {
    if (isWritable(encoding, folder)) {
      writable.push_back(encoding);
    }
  }
  return writable;
}

VideoEncoder::VideoEncoder(VideoOutput output, fs::path part,
                           std::unique_ptr<cv::VideoWriter> video)
    : output_(std::move(output)), part_(std::move(part)), video_(std::move(video)) {}

VideoEncoder::VideoEncoder(VideoEncoder&& other) noexcept
    : output_(std::move(other.output_)), part_(std::exchange(other.part_, {})),
      video_(std::move(other.video_)), frames_(other.frames_) {}

VideoEncoder::~VideoEncoder() {
  try {
    video_.reset();
  } catch (const std::exception&) { // of the library: the file is removed anyway
  }
  if (!part_.empty()) {
    std::error_code ignored;
    fs::remove(part_, ignored);
  }
}

Result<VideoEncoder> VideoEncoder::create(const VideoOutput& output) {
  if (const Status valid = checkOutput(output); !valid) {
    return tl::make_unexpected(valid.error());
  }
  std::error_code problem;
  VideoOutput absolute = output;
  absolute.file = fs::absolute(output.file, problem);
  const fs::path part = temporaryFileOf(absolute.file);
  auto empty = GrowingFile::create(part); // it says why a file cannot be made, the library does not
  if (!empty) {
    empty.error().file = output.file.string();
    return tl::make_unexpected(empty.error());
  }
  (void)empty->close();
  VideoEncoder encoder(std::move(absolute), part, nullptr); // from here on, the file is removed
  if (const Status space = encoder.checkSpace(); !space) {
    return tl::make_unexpected(space.error());
  }
  auto video = openVideo(encoder.output_, part);
  if (!video) {
    return tl::make_unexpected(video.error());
  }
  encoder.video_ = std::move(*video);
  return encoder;
}

Status VideoEncoder::checkSpace() const {
  std::error_code problem;
  const fs::space_info space = fs::space(output_.file.parent_path(), problem);
  if (!problem && space.available < output_.reserve) {
    return failure(ErrorCode::FileUnwritable, output_.file.string(), "", std::strerror(ENOSPC));
  }
  return {};
}

Status VideoEncoder::write(const cv::Mat& image) {
  if (!video_) {
    return failure(ErrorCode::FileUnwritable, output_.file.string(), "", "it is already closed");
  }
  if (image.cols != output_.width || image.rows != output_.height) {
    return failure(ErrorCode::Mismatch, output_.file.string(), "",
                   fmt::format("image {} is {} x {}, but the video is {} x {}", frames_, image.cols,
                               image.rows, output_.width, output_.height));
  }
  if (image.type() != CV_8UC3 && image.type() != CV_8UC4) {
    return failure(ErrorCode::BadValue, output_.file.string(), "",
                   "an image must have three or four 8-bit channels");
  }
  if (const Status space = checkSpace(); !space) {
    return space;
  }
  try {
    cv::Mat colors = image;
    if (image.type() == CV_8UC4) {
      cv::cvtColor(image, colors, cv::COLOR_BGRA2BGR);
    }
    video_->write(colors);
  } catch (const std::exception& problem) {
    return failure(ErrorCode::FileUnwritable, output_.file.string(), "", problem.what());
  }
  ++frames_;
  return {};
}

Status VideoEncoder::finish() {
  if (!video_) {
    return failure(ErrorCode::FileUnwritable, output_.file.string(), "", "it is already closed");
  }
  try {
    video_.reset();
    // The encoder does not report what it could not write; a video that cannot be read back tells.
    cv::VideoCapture check(part_.string(), cv::CAP_FFMPEG);
    const double announced = check.isOpened() ? check.get(cv::CAP_PROP_FRAME_COUNT) : 0.0;
    // Some containers store the duration, not the count: one frame either way is rounding.
    if (std::abs(announced - static_cast<double>(frames_)) > 1.5) {
      return failure(ErrorCode::FileUnwritable, output_.file.string(), "",
                     "the video is incomplete; the disk may be full");
    }
  } catch (const std::exception& problem) {
    return failure(ErrorCode::FileUnwritable, output_.file.string(), "", problem.what());
  }
  std::error_code problem;
  fs::rename(part_, output_.file, problem);
  if (problem) {
    return failure(ErrorCode::FileUnwritable, output_.file.string(), "", problem.message());
  }
  part_.clear();
  return {};
}

} // namespace dewpoint::capture
