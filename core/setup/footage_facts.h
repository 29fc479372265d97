// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// What a recording shows before a project is made of it.
struct FootageFacts {
  int width = 0;                ///< pixels, as stored
  int height = 0;               ///< pixels, as stored
  double framesPerSecond = 0.0; ///< as the video states it; 0: a folder of images, or not stated
  std::int64_t frames = 0;
  cv::Mat preview; ///< the first image, CV_8UC3 (BGR), scaled down
};

/// Opens a video or a folder of images, reads its first image, and closes it again: may take long.
/// Nothing for what is not a file or folder (a device, an address, a pipe): it is not tried.
/// FileMissing and FileUnreadable name the file.
Result<std::optional<FootageFacts>> readFootageFacts(const std::string& location);

/// In which respects recordings that belong together differ.
struct FootageDifferences {
  std::optional<std::int64_t> shortest; ///< frames of the shortest, when they differ in length
  bool sizes = false;
  bool rates = false; ///< of those whose rates are known; by more than rounding

  bool operator==(const FootageDifferences&) const = default;
};
FootageDifferences footageDifferences(const std::vector<FootageFacts>& recordings);

} // namespace dewpoint::setup
