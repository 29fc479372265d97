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
  std::string_view id;     ///< name in this program, for example "h264"
  std::string_view suffix; ///< file name suffix, including the dot
  std::string_view codec;  ///< four-character code for OpenCV
};

/// Returns all known encodings. The first one plays on most computers; the last one is lossless.
std::span<const VideoEncoding> videoEncodings();

/// Returns the encodings that this computer can write, in the order of videoEncodings(). To find
/// out, writes a short video in each encoding to `folder`, reads it back and removes it. This takes
/// about a second.
std::vector<VideoEncoding> writableVideoEncodings(const std::filesystem::path& folder);

/// File, format and image size of a video that a VideoEncoder writes.
struct VideoOutput {
  std::filesystem::path file;
  VideoEncoding encoding;
  double framesPerSecond = 30.0;
  /// Pixels; must be even, because H.264 and VP8 store one color for each 2 x 2 pixels.
  int width = 0;
  int height = 0; ///< pixels; must be even
  /// Free space that must remain on the disk, bytes. Writing fails if there is less, because the
  /// encoder does not report a full disk.
  std::uintmax_t reserve = std::uintmax_t{32} << 20U;
};

/// Writes a video to a temporary file in the same folder. finish() renames this file. Without a
/// successful finish(), the temporary file is removed, and an existing video is not changed.
class VideoEncoder {
public:
  /// Creates the temporary file and starts the video. Errors: BadValue for an invalid size, rate or
  /// encoding; FileUnwritable.
  static Result<VideoEncoder> create(const VideoOutput& output);

  VideoEncoder(VideoEncoder&& other) noexcept;
  VideoEncoder& operator=(VideoEncoder&& other) = delete;
  ~VideoEncoder(); ///< removes the temporary file unless finish() has renamed it

  /// Appends one image: CV_8UC3 (blue, green, red) or CV_8UC4 (the fourth channel is ignored).
  /// Errors: Mismatch if the image does not have the size of the output; BadValue for another image
  /// type; FileUnwritable, for example if the disk is nearly full.
  Status write(const cv::Mat& image);
  /// Completes the video, checks that it contains all images, and gives the file its final name.
  /// Later writes fail. Error: FileUnwritable.
  Status finish();
  std::int64_t writtenFrameCount() const { return frames_; }

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
