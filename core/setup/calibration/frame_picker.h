// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_source.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <filesystem>
#include <vector>

namespace dewpoint::setup {

/// Reads single frames of a recording, in rising order: it seeks if the next one is far, and reads
/// on otherwise, which is faster.
class FramePicker {
public:
  explicit FramePicker(FrameSetSource& source) : source_(source) {}

  /// Returns the frame, null if the recording is shorter than its frame count, or the errors of the
  /// source.
  Result<FrameSetPtr> read(std::int64_t frame);

private:
  FrameSetSource& source_;
  std::int64_t next_ = -1; ///< frame that the source delivers next; -1: not known yet
};

/// Returns `count` numbers from 0 to `total` - 1, or all of them if there are fewer: the middles of
/// equal parts, ascending.
std::vector<std::int64_t> evenlySpaced(std::int64_t total, std::int64_t count);

/// Reads an image file in gray (CV_8UC1). Returns FileMissing or FileUnreadable.
Result<cv::Mat> readGrayPicture(const std::filesystem::path& file);

} // namespace dewpoint::setup
