// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/video_reader.h"

#include "core/base/lower_case.h"
#include "core/base/units.h"

#include <fmt/format.h>
#include <opencv2/videoio.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace dewpoint::capture {
namespace {

/// Decoding this many frames costs about as much as one seek to the key frame before them.
constexpr std::int64_t kSkipInsteadOfSeek = 32;
/// A header that announces more frames than this (a year at 100 per second) is a mistake.
constexpr double kMostFrames = 3.2e9;

class VideoReader final : public FrameReader {
public:
  VideoReader(std::string path, std::string field, std::optional<RecordedStamps> recorded)
      : path_(std::move(path)), field_(std::move(field)), recorded_(std::move(recorded)) {}

  Status open();
  std::int64_t frameCount() const override { return count_; }
  double framesPerSecond() const override { return rate_; }
  Result<cv::Mat> read(std::int64_t frame) override;
  std::string fileOf(std::int64_t) const override { return path_; }

private:
  bool reopen();
  bool grab();
  bool moveTo(std::int64_t frame);
  bool seekTo(std::int64_t frame);
  bool isFrame(std::int64_t frame) const;
  void readHeader();
  void countFrames();
  void countPackets();
  bool seekByStamp(std::int64_t frame);
  double recordedStamp(std::int64_t frame) const;
  tl::unexpected<Error> unreadable(std::string detail) const {
    return failure(ErrorCode::FileUnreadable, path_, field_, std::move(detail));
  }
  Result<cv::Mat> missing(std::int64_t frame) const;

  std::string path_;
  std::string field_;
  std::optional<RecordedStamps> recorded_;
  cv::VideoCapture video_;
  std::int64_t count_ = 0;
  bool counted_ = false; ///< counted frame by frame: the header says nothing, nor can it seek
  double rate_ = 0;
  std::int64_t position_ = 0;  ///< frames grabbed: the next grab gives this one
  std::vector<double> stamps_; ///< milliseconds of frames 0, 1, ... as far as read in a row
};

bool VideoReader::reopen() {
  position_ = 0;
  // An absolute path, because FFmpeg takes what stands before a colon for a protocol.
  return video_.open(std::filesystem::absolute(path_).string(), cv::CAP_FFMPEG);
}

bool VideoReader::grab() {
  if (!video_.grab()) {
    return false;
  }
  if (position_ == std::ssize(stamps_)) {
    stamps_.push_back(video_.get(cv::CAP_PROP_POS_MSEC));
  }
  ++position_;
  return true;
}

void VideoReader::readHeader() {
  const double rate = video_.get(cv::CAP_PROP_FPS);
  rate_ = std::isfinite(rate) && rate > 0 && rate <= 10000 ? rate : 0;
  const double announced = video_.get(cv::CAP_PROP_FRAME_COUNT);
  counted_ = !(announced >= 1 && announced <= kMostFrames);
  count_ = counted_ ? 0 : std::llround(announced);
}

void VideoReader::countFrames() {
  while (grab()) {
  }
  count_ = position_;
  reopen();
}

/// Counts without decoding.
void VideoReader::countPackets() {
  if (video_.open(std::filesystem::absolute(path_).string(), cv::CAP_FFMPEG,
                  {cv::CAP_PROP_FORMAT, -1})) {
    for (count_ = 0; video_.grab(); ++count_) {
    }
  }
  reopen();
}

Status VideoReader::open() {
  std::error_code ignored;
  if (!std::filesystem::exists(path_, ignored)) {
    return failure(ErrorCode::FileMissing, path_, field_, "");
  }
  if (!std::filesystem::is_regular_file(path_, ignored)) {
    return unreadable("a video file is expected here");
  }
  try {
    if (!reopen()) {
      return unreadable("it is not a video, is cut off, or has an unknown format");
    }
    readHeader();
    if (recorded_ && recorded_->isComplete) {
      count_ = std::ssize(recorded_->times);
      counted_ = false;
    } else if (recorded_) {
      counted_ = true;
      countPackets();
    } else if (counted_) {
      countFrames();
    }
  } catch (const std::exception& problem) {
    return unreadable(problem.what());
  }
  if (count_ == 0) {
    return unreadable("the video contains no images");
  }
  return {};
}

/// Whether the frame grabbed last is this one, by its time stamp.
bool VideoReader::isFrame(std::int64_t frame) const {
  if (stamps_.empty() || rate_ <= 0) {
    return false;
  }
  const double interval = 1000.0 / rate_;
  const double expected = frame < std::ssize(stamps_)
                              ? stamps_[static_cast<std::size_t>(frame)]
                              : stamps_.front() + static_cast<double>(frame) * interval;
  return std::abs(video_.get(cv::CAP_PROP_POS_MSEC) - expected) < 0.4 * interval;
}

/// Time stamp of a frame by the table of its recording, milliseconds.
double VideoReader::recordedStamp(std::int64_t frame) const {
  const auto& times = recorded_->times;
  return stamps_.front() + inMilliseconds(times[static_cast<std::size_t>(frame)] - times.front());
}

/// Jumps to shortly before a frame, and goes on to it. Afterwards the frame is grabbed.
bool VideoReader::seekByStamp(std::int64_t frame) {
  // OpenCV counts frames by their time and the mean rate; a few more for what lies between.
  constexpr int kFramesBefore = 4;
  constexpr int kMostSteps = 24;
  constexpr double kRounding = 1.5; // milliseconds; the container has whole ones
  const double sought = recordedStamp(frame);
  const double nominal = fromMilliseconds(sought) * rate_ - kFramesBefore;
  if (counted_ || rate_ <= 0 || nominal < 1 ||
      !video_.set(cv::CAP_PROP_POS_FRAMES, std::floor(nominal))) {
    return false;
  }
  for (int step = 0; step < kMostSteps && video_.grab(); ++step) {
    const double stamp = video_.get(cv::CAP_PROP_POS_MSEC);
    if (stamp > sought - kRounding) {
      position_ = frame + 1;
      return stamp < sought + kRounding;
    }
  }
  return false;
}

/// Jumps, and looks whether it arrived. Afterwards the frame is grabbed.
bool VideoReader::seekTo(std::int64_t frame) {
  if (recorded_ && !stamps_.empty()) {
    return seekByStamp(frame);
  }
  if (counted_ || !video_.set(cv::CAP_PROP_POS_FRAMES, static_cast<double>(frame))) {
    return false;
  }
  if (!video_.grab() || !isFrame(frame)) {
    return false;
  }
  position_ = frame + 1;
  return true;
}

/// Grabs exactly this frame: by going on, by a checked jump, or from the start when a jump failed.
bool VideoReader::moveTo(std::int64_t frame) {
  const std::int64_t ahead = frame - position_;
  if (ahead < 0 || (ahead > kSkipInsteadOfSeek && !counted_)) {
    if (seekTo(frame)) {
      return true;
    }
    if (!reopen()) {
      return false;
    }
  }
  while (position_ <= frame) {
    if (!grab()) {
      return false;
    }
  }
  return true;
}

Result<cv::Mat> VideoReader::read(std::int64_t frame) {
  try {
    cv::Mat picture;
    if (!moveTo(frame)) {
      return missing(frame);
    }
    if (!video_.retrieve(picture) || picture.empty()) {
      return unreadable(fmt::format("image {} cannot be decoded", frame));
    }
    return picture;
  } catch (const std::exception& problem) {
    return unreadable(fmt::format("picture {}: {}", frame, problem.what()));
  }
}

Result<cv::Mat> VideoReader::missing(std::int64_t frame) const {
  const std::string kind = toLowerCase(std::filesystem::path(path_).extension().string());
  // Only these containers store the number of frames; for the others it is the duration times the
  // rate, which may be one too many.
  const bool exact = kind == ".mp4" || kind == ".mov" || kind == ".m4v" || kind == ".avi";
  if (!exact && position_ > 0 && position_ == frame && frame + 1 >= count_) {
    return cv::Mat();
  }
  return failure(
      ErrorCode::EndedEarly, path_, field_,
      fmt::format("it should contain {} images but contains only {}", count_, position_));
}

} // namespace

std::optional<RecordedStamps> readRecordedStamps(const std::string& table,
                                                 const std::vector<std::string>& ids) {
  const TableCompleteness completeness =
      table.empty() ? TableCompleteness::Unknown : completenessOf(table);
  if (completeness == TableCompleteness::Unknown) {
    return std::nullopt;
  }
  auto times = readCaptureTimes(table, ids, "");
  return times ? std::optional(
                     RecordedStamps{std::move(*times), completeness == TableCompleteness::Complete})
               : std::nullopt;
}

Result<FrameReaderPtr> openVideoReader(const std::string& path, const std::string& field,
                                       std::optional<RecordedStamps> recorded) {
  auto reader = std::make_unique<VideoReader>(path, field, std::move(recorded));
  if (auto opened = reader->open(); !opened) {
    return tl::make_unexpected(opened.error());
  }
  return reader;
}

} // namespace dewpoint::capture
