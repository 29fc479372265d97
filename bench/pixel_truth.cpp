// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/pixel_truth.h"

#include <Eigen/Geometry>

#include <cstdint>

namespace dewpoint::bench {

PixelScore pixelScore(const cv::Mat& match, const cv::Mat& truth) {
  PixelScore score;
  score.both = cv::countNonZero(match & truth);
  score.found = cv::countNonZero(match);
  score.truth = cv::countNonZero(truth);
  return score;
}

cv::Mat ballMask(const Camera& camera, const Eigen::Vector3d& position, double radius) {
  const Eigen::Vector3d ball = camera.cameraFromWorld * position;
  const Intrinsics& lens = camera.intrinsics;
  cv::Mat mask = cv::Mat::zeros(lens.height, lens.width, CV_8UC1);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const Eigen::Vector3d ray((x - lens.centerX) / lens.focalX, (y - lens.centerY) / lens.focalY,
                                1.0);
      mask.at<std::uint8_t>(y, x) = ray.normalized().cross(ball).norm() < radius ? 255 : 0;
    }
  }
  return mask;
}

} // namespace dewpoint::bench
