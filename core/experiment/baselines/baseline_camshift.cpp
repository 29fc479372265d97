// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/baseline_camshift.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

namespace dewpoint::experiment {
namespace {

constexpr int kIterations = 10;
constexpr double kStep = 1.0; // pixels, OpenCV's custom

bool hasColor(const cv::Mat& mask, const cv::Rect& window) {
  return !window.empty() && cv::countNonZero(mask(window)) >= kMinBlobArea;
}

/// The box of the largest blob, empty if there is none.
cv::Rect largestBox(const cv::Mat& mask) {
  cv::Mat labels;
  cv::Mat statistics;
  cv::Mat centers;
  const int count = cv::connectedComponentsWithStats(mask, labels, statistics, centers, 8, CV_32S);
  int best = 0;
  for (int label = 1; label < count; ++label) {
    const int area = statistics.at<int>(label, cv::CC_STAT_AREA);
    if (area >= kMinBlobArea && (best == 0 || area > statistics.at<int>(best, cv::CC_STAT_AREA))) {
      best = label;
    }
  }
  return best == 0 ? cv::Rect()
                   : cv::Rect(statistics.at<int>(best, cv::CC_STAT_LEFT),
                              statistics.at<int>(best, cv::CC_STAT_TOP),
                              statistics.at<int>(best, cv::CC_STAT_WIDTH),
                              statistics.at<int>(best, cv::CC_STAT_HEIGHT));
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

Eigen::Vector2d centerOfMass(const cv::Mat& mask, const cv::Rect& window) {
  const cv::Moments moments = cv::moments(mask(window), true);
  return {window.x + moments.m10 / moments.m00, window.y + moments.m01 / moments.m00};
}

} // namespace

std::vector<std::optional<Eigen::Vector2d>>
CamShiftFinder::find(const std::vector<cv::Mat>& masks) {
  windows_.resize(masks.size());
  std::vector<std::optional<Eigen::Vector2d>> result(masks.size());
  for (std::size_t camera = 0; camera < masks.size(); ++camera) {
    const cv::Mat& mask = masks[camera];
    cv::Rect& window = windows_[camera];
    if (mask.empty()) {
      window = {};
      continue;
    }
    if (!hasColor(mask, window)) {
      window = largestBox(mask);
    }
    if (!window.empty()) {
      window = shifted(mask, window);
    }
    if (hasColor(mask, window)) {
      result[camera] = centerOfMass(mask, window);
    }
  }
  return result;
}

} // namespace dewpoint::experiment
