// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/frame_picker.h"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>

namespace dewpoint::setup {
namespace {

constexpr std::int64_t kSeekFrom = 12; // frames to pass over: fewer are read faster than sought

} // namespace

Result<FrameSetPtr> FramePicker::read(std::int64_t frame) {
  if (next_ < 0 || frame - next_ > kSeekFrom) {
    if (const auto sought = source_.seek(frame); !sought) {
      return tl::make_unexpected(sought.error());
    }
    next_ = frame;
  }
  Result<FrameSetPtr> set = nullptr;
  do {
    set = source_.next();
  } while (set && *set != nullptr && next_++ < frame);
  return set;
}

std::vector<std::int64_t> evenlySpacedFrames(std::int64_t total, std::int64_t count) {
  const std::int64_t parts = std::min(total, count);
  std::vector<std::int64_t> numbers;
  for (std::int64_t k = 0; k < parts; ++k) {
    numbers.push_back((2 * k + 1) * total / (2 * parts));
  }
  return numbers;
}

Result<cv::Mat> readGrayPicture(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) {
    return failure(ErrorCode::FileMissing, file.string(), "", "");
  }
  cv::Mat picture = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
  if (picture.empty()) {
    return failure(ErrorCode::FileUnreadable, file.string(), "", "it is not an image");
  }
  return picture;
}

} // namespace dewpoint::setup
