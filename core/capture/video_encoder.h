// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cv {
class VideoWriter;
}

namespace dewpoint::capture {

/// Codec and container of videos that are made to be watched.
struct VideoEncoding {
  std::string_view id;     ///< "h264"
  std::string_view suffix; ///< of the file name, with the dot
  std::string_view codec;  ///< four characters, as OpenCV names it
};

/// Returns all known encodings, the most widely played first; the last one is lossless.
std::span<const VideoEncoding> videoEncodings();

/// Returns the encodings that this computer can write, in the order of videoEncodings(). Writes a
/// short video of each into `folder`, reads it back and removes it, which takes about a second.
std::vector<VideoEncoding> writableVideoEncodings(const std::filesystem::path& folder);

/// What a VideoEncoder writes.
struct VideoOutput {
  std::filesystem::path file;
  VideoEncoding encoding;
  double framesPerSecond = 30.0;
  int width = 0; ///< pixels; even, as H.264 and VP8 store colors for each 2 x 2 pixels
  int height = 0;
  /// Free space (bytes) that must remain on the disk, because the encoder does not report a full
  /// one. It is more than an encoder holds back.
  std::uintmax_t reserve = std::uintmax_t{32} << 20U;
};

/// Writes a video under a temporary name beside its file, and renames it when it is complete.
/// Without finish(), nothing is left, and an older file stays unchanged.
class VideoEncoder {
public:
  /// Errors: BadValue, FileUnwritable.
  static Result<VideoEncoder> create(const VideoOutput& output);

  VideoEncoder(VideoEncoder&& other) noexcept;
  VideoEncoder& operator=(VideoEncoder&& other) = delete;
  ~VideoEncoder(); ///< removes the temporary file

  /// Appends one image: CV_8UC3 (blue, green, red) or CV_8UC4 (the fourth is ignored), of the size
  /// of the output. Error: FileUnwritable, if the disk is nearly full.
  Status write(const cv::Mat& image);
  /// Completes the file and checks that it can be read back whole. Later writes fail.
  Status finish();
  std::int64_t framesWritten() const { return frames_; }

private:
  VideoEncoder(VideoOutput output, std::filesystem::path part,
               std::unique_ptr<cv::VideoWriter> video);
  Status checkSpace() const;

  VideoOutput output_;
  std::filesystem::path part_; ///< temporary file; empty when there is none
  std::unique_ptr<cv::VideoWriter> video_;
  std::int64_t frames_ = 0;
};

} // namespace dewpoint::capture
