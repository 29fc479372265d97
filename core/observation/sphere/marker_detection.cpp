// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/sphere/marker_detection.h"

#include "core/color/match_image.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace dewpoint::observation {
namespace {

// Origin of the values not recorded.

constexpr double kOthersShare = 0.5;  ///< of the patch's area that others may have in sum
constexpr double kLongest = 1.8;      ///< ratio of the axes: motion blur, and balls seen aside
constexpr double kLeastFilled = 0.93; ///< share of the ellipse of the same moments that is filled
constexpr double kLeastHeld = 0.75;   ///< share of the filled patch that matches: highlights miss

/// A patch filled, in its own small image.
struct Patch {
  cv::Mat filled; ///< CV_8UC1, one pixel of margin
  cv::Point origin;
};

Patch filledPatch(const cv::Mat& labels, int label, const cv::Rect& area) {
  cv::Mat own;
  cv::copyMakeBorder(labels(area) == label, own, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(own, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  cv::Mat filled = cv::Mat::zeros(own.size(), CV_8UC1);
  cv::drawContours(filled, outlines, -1, cv::Scalar(1), cv::FILLED);
  return {filled, {area.x - 1, area.y - 1}};
}

/// Whether a patch of these moments is a filled ellipse, and not too long a one. A filled ellipse
/// with half axes a and b has the area pi a b and the variances a²/4 and b²/4.
bool isRound(const cv::Moments& m) {
  const double pixel = 1.0 / 12.0; // the variance within a pixel
  const double xx = m.mu20 / m.m00 + pixel;
  const double yy = m.mu02 / m.m00 + pixel;
  const double xy = m.mu11 / m.m00;
  const double mean = 0.5 * (xx + yy);
  const double half = std::hypot(0.5 * (xx - yy), xy);
  const double least = mean - half;
  if (!(least > 0.0) || std::sqrt((mean + half) / least) > kLongest) {
    return false;
  }
  const double ellipse = 4.0 * std::numbers::pi * std::sqrt((mean + half) * least);
  return m.m00 > kLeastFilled * ellipse;
}

} // namespace

std::optional<MarkerImage> MarkerDetector::find(const cv::Mat& bgr) {
  if (bgr.empty()) {
    return std::nullopt;
  }
  matchImage(bgr, classifier_, match_);
  const int count = cv::connectedComponentsWithStats(match_, labels_, stats_, middles_, 8, CV_32S);
  int best = 0;
  double sum = 0.0;
  for (int label = 1; label < count; ++label) {
    const int area = stats_.at<int>(label, cv::CC_STAT_AREA);
    sum += area;
    if (best == 0 || area > stats_.at<int>(best, cv::CC_STAT_AREA)) {
      best = label;
    }
  }
  if (best == 0) {
    return std::nullopt;
  }
  const double held = stats_.at<int>(best, cv::CC_STAT_AREA);
  const cv::Rect area(stats_.at<int>(best, cv::CC_STAT_LEFT), stats_.at<int>(best, cv::CC_STAT_TOP),
                      stats_.at<int>(best, cv::CC_STAT_WIDTH),
                      stats_.at<int>(best, cv::CC_STAT_HEIGHT));
  const bool cut =
      area.x < 2 || area.y < 2 || area.br().x > bgr.cols - 2 || area.br().y > bgr.rows - 2;
  if (cut || sum - held > kOthersShare * held ||
      held < std::numbers::pi * kMinRadiusPixels * kMinRadiusPixels) {
    return std::nullopt;
  }
  const Patch patch = filledPatch(labels_, best, area);
  const cv::Moments m = cv::moments(patch.filled, true);
  if (held < kLeastHeld * m.m00 || !isRound(m)) {
    return std::nullopt;
  }
  return fitBallEdge(bgr, {{m.m10 / m.m00 + patch.origin.x, m.m01 / m.m00 + patch.origin.y},
                           std::sqrt(m.m00 / std::numbers::pi)});
}

} // namespace dewpoint::observation
