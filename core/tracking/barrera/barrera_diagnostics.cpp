// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/barrera/barrera_diagnostics.h"

#include "core/color/match_image.h"
#include "core/observation/sphere/window_counts.h"

#include <opencv2/imgproc.hpp>

#include <cmath>

namespace dewpoint::tracking {

CameraReport reportByColor(const cv::Mat& image, const ColorClassifier& color,
                           const Projector& projector, const SphereEstimate& estimate,
                           std::size_t camera) {
  if (image.empty()) {
    return {CameraStatus::NoImage, 0.0};
  }
  const bool known = camera < estimate.cameras.size();
  if (known && estimate.cameras[camera].visibleShare > 0.0) {
    return {};
  }
  if (isDark(image)) {
    return {CameraStatus::Dark, 0.0};
  }
  const auto expected = projector.project(estimate.mean);
  const bool expectedHere = expected && known && estimate.cameras[camera].isInView;
  if (!expectedHere && estimate.isValid) {
    return {CameraStatus::OutOfView, 0.0};
  }
  // A position that is only searched from does not say that the target is outside the image.
  if (!expected) {
    return cv::countNonZero(matchImage(image, color)) > 0
               ? CameraReport{} // behind the camera there is no distance to name
               : CameraReport{CameraStatus::NoColor, 0.0};
  }
  const auto distance = distanceToNearestMaskPixel(matchImage(image, color), *expected);
  return distance ? CameraReport{CameraStatus::Elsewhere, *distance}
                  : CameraReport{CameraStatus::NoColor, 0.0};
}

LikelihoodMap windowLikelihoodMap(const cv::Mat& image, const ColorClassifier& color,
                                  const Projector& projector, const Eigen::Vector3d& position,
                                  int reach) {
  LikelihoodMap map;
  const auto center = projector.project(position);
  const cv::Rect whole(cv::Point(0, 0), image.size());
  if (!center || image.empty() ||
      !whole.contains(cv::Point(cvRound(center->x()), cvRound(center->y())))) {
    return map;
  }
  map.area = cv::Rect(cvRound(center->x()) - reach, cvRound(center->y()) - reach, 2 * reach + 1,
                      2 * reach + 1) &
             whole;
  map.minLogLikelihood = std::log(1.0 / WindowCounts::kWindowPixelCount);
  map.maxLogLikelihood = 0.0;
  cv::Mat counts; // windows cut by the border count the pixels they have
  cv::boxFilter(matchImage(image, color) / 255, counts, CV_32F,
                {2 * WindowCounts::kRadius + 1, 2 * WindowCounts::kRadius + 1}, {-1, -1}, false,
                cv::BORDER_CONSTANT);
  cv::log(cv::max(counts(map.area), 1.0) / WindowCounts::kWindowPixelCount, map.logLikelihood);
  return map;
}

} // namespace dewpoint::tracking
