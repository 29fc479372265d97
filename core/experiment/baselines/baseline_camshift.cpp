// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/baseline_camshift.h"

#include "core/experiment/baselines/baseline_blobs.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include <cmath>
#include <numbers>

namespace dewpoint::experiment {
namespace {

// When the search ends, as in OpenCV's example of CAMShift.
constexpr int kIterations = 10;
constexpr double kStep = 1.0; // pixels

bool hasColor(const cv::Mat& mask, const cv::Rect& window) {
  return !window.empty() && cv::countNonZero(mask(window)) >= kMinBlobArea;
}

cv::Rect shifted(const cv::Mat& mask, cv::Rect window) {
  try {
    cv::CamShift(
        mask, window,
        cv::TermCriteria(cv::TermCriteria::EPS | cv::TermCriteria::COUNT, kIterations, kStep));
  } catch (const cv::Exception&) {
    return {}; // it refuses windows that have shrunk to nothing: lost
  }
  return window & cv::Rect(0, 0, mask.cols, mask.rows);
}

FollowedPixel massIn(const cv::Mat& mask, const cv::Rect& window) {
  const cv::Moments moments = cv::moments(mask(window), true);
  return {{window.x + moments.m10 / moments.m00, window.y + moments.m01 / moments.m00},
          std::sqrt(moments.m00 / std::numbers::pi)};
}

} // namespace

bool CamShiftFollower::start(const CameraImages& images, const cv::Rect& box) {
  window_ = box & cv::Rect(0, 0, images.mask.cols, images.mask.rows);
  return hasColor(images.mask, window_);
}

std::optional<FollowedPixel> CamShiftFollower::step(const CameraImages& images) {
  if (!hasColor(images.mask, window_)) {
    return std::nullopt;
  }
  window_ = shifted(images.mask, window_);
  return hasColor(images.mask, window_) ? std::optional(massIn(images.mask, window_))
                                        : std::nullopt;
}

} // namespace dewpoint::experiment
