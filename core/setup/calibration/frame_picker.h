// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_source.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <filesystem>
#include <vector>

namespace dewpoint::setup {

/// Reads single frames of a recording, in ascending order. It seeks if the next requested frame is
/// far away. Otherwise it reads the frames in between, which is faster.
class FramePicker {
public:
  explicit FramePicker(FrameSetSource& source) : source_(source) {}

  /// Returns the images of frame `frame`. They are null if the recording has fewer frames than its
  /// source states. Returns the errors of the source.
  Result<FrameSetPtr> read(std::int64_t frame);

private:
  FrameSetSource& source_;
  std::int64_t next_ = -1; ///< frame that the source delivers next; -1: not known yet
};

/// Returns `count` evenly spaced numbers from 0 to `total` - 1, ascending: the range is divided
/// into equal parts, and each number is the center of one part. Returns all numbers if `total` is
/// less than `count`.
std::vector<std::int64_t> evenlySpacedFrames(std::int64_t total, std::int64_t count);

/// Reads an image file in gray (CV_8UC1). Returns FileMissing or FileUnreadable.
Result<cv::Mat> readGrayPicture(const std::filesystem::path& file);

} // namespace dewpoint::setup
