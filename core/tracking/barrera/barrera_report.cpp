// SPDX-License-Identifier: GPL-3.0-or-later
// What method barrera tells of itself: memory, reasons and likelihood maps.
#include "core/color/match_image.h"
#include "core/tracking/barrera/barrera_tracker.h"

#include <opencv2/imgproc.hpp>

#include <cmath>

namespace dewpoint::tracking {

std::size_t BarreraTracker::memoryBytes() const {
  // With many particles also the counts over the whole images.
  std::size_t bytes = RandomWalkTracker::memoryBytes();
  for (std::size_t camera = 0; camera < observation_.cameraCount(); ++camera) {
    bytes += imageOf(camera).total();
  }
  return bytes;
}

CameraReport BarreraTracker::explain(std::size_t camera) const {
  const cv::Mat image = imageOf(camera);
  if (image.empty()) {
    return {CameraStatus::NoImage, 0.0};
  }
  const bool known = camera < estimate_.cameras.size();
  if (known && estimate_.cameras[camera].visible > 0.0) {
    return {};
  }
  if (isDark(image)) {
    return {CameraStatus::Dark, 0.0};
  }
  const auto expected = projectors_[camera].project(estimate_.mean);
  if (!expected || !known || !estimate_.cameras[camera].inView) {
    return {CameraStatus::OutOfView, 0.0};
  }
  const auto distance = distanceToNearest(matchImage(image, classifier_), *expected);
  return distance ? CameraReport{CameraStatus::Elsewhere, *distance}
                  : CameraReport{CameraStatus::NoColor, 0.0};
}

std::vector<CameraReport> BarreraTracker::explain() const {
  std::vector<CameraReport> reports;
  for (std::size_t camera = 0; camera < observation_.cameraCount(); ++camera) {
    reports.push_back(explain(camera));
  }
  return reports;
}

std::vector<LikelihoodMap> BarreraTracker::likelihoodMaps(int reach) const {
  std::vector<LikelihoodMap> maps(observation_.cameraCount());
  for (std::size_t camera = 0; camera < maps.size(); ++camera) {
    const cv::Mat image = imageOf(camera);
    const auto middle = projectors_[camera].project(estimate_.mean);
    const cv::Rect whole(cv::Point(0, 0), image.size());
    if (!middle || image.empty() ||
        !whole.contains(cv::Point(cvRound(middle->x()), cvRound(middle->y())))) {
      continue;
    }
    LikelihoodMap& map = maps[camera];
    map.area = cv::Rect(cvRound(middle->x()) - reach, cvRound(middle->y()) - reach, 2 * reach + 1,
                        2 * reach + 1) &
               whole;
    map.least = std::log(1.0 / WindowCounts::kPixels);
    map.most = 0.0;
    cv::Mat counts; // windows cut by the border count the pixels they have
    cv::boxFilter(matchImage(image, classifier_) / 255, counts, CV_32F,
                  {2 * WindowCounts::kRadius + 1, 2 * WindowCounts::kRadius + 1}, {-1, -1}, false,
                  cv::BORDER_CONSTANT);
    cv::log(cv::max(counts(map.area), 1.0) / WindowCounts::kPixels, map.logLikelihood);
  }
  return maps;
}

} // namespace dewpoint::tracking
