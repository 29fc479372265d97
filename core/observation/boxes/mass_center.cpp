// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/boxes/mass_center.h"

#include "core/color/match_image.h"

#include <opencv2/imgproc.hpp>

namespace dewpoint::observation {

std::optional<Eigen::Vector2d> centerOfMass(const cv::Mat& bgr, const ColorClassifier& classifier) {
  const cv::Mat match = matchImage(bgr, classifier);
  if (match.empty()) {
    return std::nullopt;
  }
  const cv::Moments mass = cv::moments(match, true);
  if (mass.m00 < kMinMassPixels) {
    return std::nullopt;
  }
  return Eigen::Vector2d(mass.m10 / mass.m00, mass.m01 / mass.m00);
}

} // namespace dewpoint::observation
