// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/match_image.h"

#include <cstdint>

namespace dewpoint::color {

void matchImage(const cv::Mat& bgr, const ColorClassifier& classifier, cv::Mat& match) {
  if (bgr.empty() || bgr.type() != CV_8UC3) {
    match.release();
    return;
  }
  match.create(bgr.rows, bgr.cols, CV_8UC1);
  if (bgr.isContinuous() && match.isContinuous()) {
    classifier.matchRow(bgr.ptr<std::uint8_t>(), static_cast<std::int64_t>(bgr.total()),
                        match.ptr<std::uint8_t>());
    return;
  }
  for (int row = 0; row < bgr.rows; ++row) {
    classifier.matchRow(bgr.ptr<std::uint8_t>(row), bgr.cols, match.ptr<std::uint8_t>(row));
  }
}

cv::Mat matchImage(const cv::Mat& bgr, const ColorClassifier& classifier) {
  cv::Mat match;
  matchImage(bgr, classifier, match);
  return match;
}

} // namespace dewpoint::color
