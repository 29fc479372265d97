// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Properties of a recording, for use before a project is created.
struct FootageFacts {
  int width = 0;  ///< width of the images as stored in the recording, pixels
  int height = 0; ///< height of the images as stored in the recording, pixels
  /// Frame rate given in the video; 0: an image folder, or the video gives none.
  double framesPerSecond = 0.0;
  std::int64_t frameCount = 0;
  cv::Mat preview; ///< first image, CV_8UC3 (BGR), scaled down
};

/// Returns the properties of a video or an image folder. It opens the recording and reads its first
/// image, which may take a long time. Anything else (a device, an address, a pipe) is not opened,
/// and nothing is returned for it. FileMissing and FileUnreadable name the file.
Result<std::optional<FootageFacts>> readFootageFacts(const std::string& location);

/// Differences between recordings that belong together.
struct FootageDifferences {
  /// Number of frames in the shortest recording, if the lengths differ.
  std::optional<std::int64_t> shortestFrameCount;
  bool imageSizesDiffer = false;
  bool frameRatesDiffer = false; ///< true if known frame rates differ by more than rounding

  bool operator==(const FootageDifferences&) const = default;
};
/// Returns the differences between recordings.
FootageDifferences footageDifferences(const std::vector<FootageFacts>& recordings);

} // namespace dewpoint::setup
