// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace dewpoint::bench {

/// Pixels that match, that are the target's, and that are both.
struct PixelScore {
  double both = 0.0, found = 0.0, truth = 0.0;
  double f1() const { return found + truth > 0.0 ? 2.0 * both / (found + truth) : 0.0; }
  void add(const PixelScore& other) {
    both += other.both;
    found += other.found;
    truth += other.truth;
  }
};

/// Of masks (CV_8UC1).
PixelScore pixelScore(const cv::Mat& match, const cv::Mat& truth);

/// 255 where the ray of a pixel hits the ball: exact but for what moves during the exposure.
cv::Mat ballMask(const Camera& camera, const Eigen::Vector3d& position, double radius);

} // namespace dewpoint::bench
