// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/background_suppression.h"

#include "core/color/color_classifier.h"
#include "core/color/match_image.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace dewpoint::color {
namespace {

bool isFamiliar(const cv::Vec3b& pixel, const cv::Vec3b& usual) {
  for (int channel = 0; channel < 3; ++channel) {
    const int allowed = kBackgroundTolerance + (usual[channel] >> kBackgroundToleranceShift);
    if (std::abs(pixel[channel] - usual[channel]) > allowed) {
      return false;
    }
  }
  return true;
}

} // namespace

std::vector<cv::Mat> suppressBackgroundColors(const ColorRanges& ranges,
                                              const std::vector<cv::Mat>& images,
                                              const std::vector<cv::Mat>& backgroundImages) {
  std::vector<cv::Mat> result = images;
  const ColorClassifier classifier(ranges);
  for (std::size_t k = 0; k < std::min(images.size(), backgroundImages.size()); ++k) {
    if (images[k].type() != CV_8UC3 || backgroundImages[k].type() != CV_8UC3 ||
        backgroundImages[k].size() != images[k].size()) {
      continue;
    }
    const cv::Mat match = matchImage(images[k], classifier);
    for (int row = 0; row < match.rows; ++row) {
      for (int column = 0; column < match.cols; ++column) {
        if (match.at<std::uint8_t>(row, column) != 0 &&
            isFamiliar(images[k].at<cv::Vec3b>(row, column),
                       backgroundImages[k].at<cv::Vec3b>(row, column))) {
          if (result[k].data == images[k].data) {
            result[k] = images[k].clone();
          }
          result[k].at<cv::Vec3b>(row, column) = {};
        }
      }
    }
  }
  return result;
}

} // namespace dewpoint::color
