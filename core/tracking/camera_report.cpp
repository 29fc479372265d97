// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/camera_report.h"

#include <fmt/format.h>
#include <opencv2/core/mat.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace dewpoint::tracking {
namespace {

// Origin of the values not recorded.

constexpr int kBrightnessGrid = 8;     ///< pixels between those whose brightness is measured
constexpr int kDarkLevel = 24;         ///< gray level, 0 to 255, above which a pixel is bright
constexpr double kBrightShare = 0.002; ///< share of bright pixels up to which an image is dark

std::string words(const CameraReport& report) {
  switch (report.status) {
  case CameraStatus::None:
    break;
  case CameraStatus::NoImage:
    return "no image";
  case CameraStatus::Covered:
    return "covered or moved";
  case CameraStatus::Dark:
    return "too dark";
  case CameraStatus::OutOfView:
    return "out of view";
  case CameraStatus::PartlyHidden:
    return "partly hidden";
  case CameraStatus::Hidden:
    return "hidden";
  case CameraStatus::Distractor:
    return report.outlineDistancePx >= 1.0
               ? fmt::format("{:.0f} px away from a distractor", report.outlineDistancePx)
               : "at a distractor";
  case CameraStatus::NoColor:
    return "no matching color";
  case CameraStatus::Elsewhere:
    return fmt::format("color found {:.0f} px away", std::max(1.0, report.outlineDistancePx));
  case CameraStatus::Unclear:
    return "right color, wrong shape";
  }
  return {};
}

} // namespace

std::string describeUnconfirmedCameras(const std::vector<CameraReport>& reports,
                                       const std::vector<std::string>& cameraNames) {
  std::string sentence;
  for (std::size_t k = 0; k < reports.size(); ++k) {
    const std::string what = words(reports[k]);
    if (!what.empty()) {
      const std::string name = k < cameraNames.size() && !cameraNames[k].empty()
                                   ? cameraNames[k]
                                   : std::to_string(k + 1);
      sentence += fmt::format("{}camera {}: {}", sentence.empty() ? "" : "; ", name, what);
    }
  }
  return sentence;
}

bool isDark(const cv::Mat& image) {
  if (image.type() != CV_8UC3 || image.empty()) {
    return false;
  }
  int bright = 0;
  int all = 0;
  for (int row = kBrightnessGrid / 2; row < image.rows; row += kBrightnessGrid) {
    const auto* pixels = image.ptr<cv::Vec3b>(row);
    for (int column = kBrightnessGrid / 2; column < image.cols; column += kBrightnessGrid) {
      const cv::Vec3b& pixel = pixels[column];
      bright += std::max({pixel[0], pixel[1], pixel[2]}) > kDarkLevel ? 1 : 0;
      ++all;
    }
  }
  return bright <= kBrightShare * all;
}

std::optional<double> distanceToNearestMaskPixel(const cv::Mat& mask,
                                                 const Eigen::Vector2d& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (int row = 0; row < mask.rows; ++row) {
    const double down = row - point.y();
    if (down * down >= nearest) {
      continue; // no pixel of this row can be nearer
    }
    const auto* pixels = mask.ptr<std::uint8_t>(row);
    for (int column = 0; column < mask.cols; ++column) {
      if (pixels[column] != 0) {
        const double across = column - point.x();
        nearest = std::min(nearest, down * down + across * across);
      }
    }
  }
  return std::isfinite(nearest) ? std::optional(std::sqrt(nearest)) : std::nullopt;
}

} // namespace dewpoint::tracking
