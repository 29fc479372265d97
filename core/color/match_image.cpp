// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/match_image.h"

#include <cstdint>

namespace dewpoint {

cv::Mat matchImage(const cv::Mat& bgr, const ColorClassifier& classifier) {
  if (bgr.empty() || bgr.type() != CV_8UC3) {
    return {};
  }
  cv::Mat match(bgr.rows, bgr.cols, CV_8UC1);
  for (int row = 0; row < bgr.rows; ++row) {
    const auto* pixel = bgr.ptr<std::uint8_t>(row);
    auto* out = match.ptr<std::uint8_t>(row);
    for (int column = 0; column < bgr.cols; ++column, pixel += 3) {
      out[column] = classifier.matches(pixel[0], pixel[1], pixel[2]) ? 255 : 0;
    }
  }
  return match;
}

} // namespace dewpoint
