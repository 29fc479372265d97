// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/view/view_image.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace dewpoint::session {
namespace {

constexpr double kTintShare = 0.25; ///< of the brightness, inside a mask
constexpr double kEdgeShare = 0.4;  ///< of the brightness stays around the contour of a mask

/// The color for a share of the way from the least to the most likely.
cv::Vec4b heat(double share) {
  // Red, green, blue.
  static constexpr std::array<std::array<double, 3>, 5> kStops{{{{13.0, 8.0, 80.0}},
                                                                {{110.0, 10.0, 140.0}},
                                                                {{200.0, 60.0, 110.0}},
                                                                {{245.0, 140.0, 50.0}},
                                                                {{250.0, 240.0, 130.0}}}};
  const double at = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double part = at - static_cast<double>(low);
  std::array<std::uint8_t, 3> color{};
  for (std::size_t k = 0; k < 3; ++k) {
    color[k] = static_cast<std::uint8_t>(
        std::lround((1.0 - part) * kStops[low][k] + part * kStops[low + 1][k]));
  }
  return {color[2], color[1], color[0], 255};
}

} // namespace

cv::Mat tintedImage(const cv::Mat& image, const cv::Mat& mask, const cv::Mat& tints) {
  cv::Mat result = image.clone();
  const cv::Rect masked = cv::boundingRect(mask); // usually a small part of the image
  if (masked.empty()) {
    return result;
  }
  cv::Mat color;
  cv::cvtColor(mask(masked), color, cv::COLOR_GRAY2BGR);
  cv::LUT(color, tints, color);
  cv::Mat bright;
  cv::addWeighted(image(masked), 1.0 - kTintShare, color, kTintShare, 0.0, bright);
  bright.copyTo(result(masked), mask(masked));
  return result;
}

void drawMaskOutline(cv::Mat& view, const cv::Mat& mask, const cv::Mat& tints) {
  cv::Mat wholeMask;
  cv::resize(mask, wholeMask, view.size(), 0.0, 0.0, cv::INTER_NEAREST);
  const cv::Rect masked = cv::boundingRect(wholeMask);
  if (masked.empty()) {
    return;
  }
  // With a margin for the dark pixels around the mask, and for the neighbors that decide on them.
  constexpr int kMargin = 2; // pixels
  const cv::Rect part =
      (masked + cv::Size(2 * kMargin, 2 * kMargin) - cv::Point(kMargin, kMargin)) &
      cv::Rect({}, view.size());
  const cv::Mat fitted = wholeMask(part).clone();
  cv::Mat area = view(part);
  cv::Mat shrunk;
  cv::Mat grown;
  cv::erode(fitted, shrunk, cv::Mat());
  cv::dilate(fitted, grown, cv::Mat());
  const cv::Mat around = (grown != fitted) & (fitted == 0);
  const cv::Mat dark = area * kEdgeShare;
  dark.copyTo(area, around);
  cv::Mat color;
  cv::cvtColor(fitted, color, cv::COLOR_GRAY2BGR);
  cv::LUT(color, tints, color);
  color.copyTo(area, shrunk != fitted);
}

cv::Mat enlargedImage(const cv::Mat& image, const cv::Size& size) {
  cv::Mat enlarged;
  cv::resize(image, enlarged, size, 0.0, 0.0, cv::INTER_NEAREST);
  return enlarged;
}

cv::Mat fittedImage(const cv::Mat& image, const cv::Size& size) {
  const bool smaller = size.width < image.cols;
  cv::Mat fitted;
  cv::resize(image, fitted, size, 0.0, 0.0, smaller ? cv::INTER_AREA : cv::INTER_LINEAR);
  return fitted;
}

cv::Mat likelihoodImage(const LikelihoodMap& map) {
  cv::Mat image(map.area.height, map.area.width, CV_8UC4);
  const double range = std::max(1e-9, map.maxLogLikelihood - map.minLogLikelihood);
  for (int row = 0; row < image.rows; ++row) {
    const auto* values = map.logLikelihood.ptr<float>(row);
    auto* line = image.ptr<cv::Vec4b>(row);
    for (int column = 0; column < image.cols; ++column) {
      line[column] = heat((static_cast<double>(values[column]) - map.minLogLikelihood) / range);
    }
  }
  return image;
}

} // namespace dewpoint::session
