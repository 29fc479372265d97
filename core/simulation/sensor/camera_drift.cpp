// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/sensor/camera_drift.h"

#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace dewpoint::simulation {

Eigen::Matrix3d rotationAt(const CameraDrift& drift, double time) {
  const double angle = drift.rotation.norm();
  if (angle == 0.0 || time <= 0.0) {
    return Eigen::Matrix3d::Identity();
  }
  // Not rotationFromVector() of a part of the vector: the axis is the same at every time, to the
  // bit.
  const double reached = -std::expm1(-time / drift.settleSeconds);
  return Eigen::AngleAxisd(reached * angle, drift.rotation / angle).toRotationMatrix();
}

Eigen::Vector3d rotatedAbout(const Eigen::Vector3d& center, const Eigen::Matrix3d& rotation,
                             const Eigen::Vector3d& point) {
  return center + rotation * (point - center);
}

cv::Mat rotatedImage(const RoomView& view, const cv::Mat& image, const Eigen::Matrix3d& rotation) {
  // Four pixels well inside the image, where every lens shows something.
  const std::array<cv::Point, 4> pixels{cv::Point{view.width / 4, view.height / 4},
                                        cv::Point{3 * view.width / 4, view.height / 4},
                                        cv::Point{view.width / 4, 3 * view.height / 4},
                                        cv::Point{3 * view.width / 4, 3 * view.height / 4}};
  std::array<cv::Point2f, 4> from;
  std::array<cv::Point2f, 4> to;
  const Eigen::Vector3d center = view.center.cast<double>();
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Eigen::Vector3d direction =
        view.directions[view.pixelIndex(pixels[i].x, pixels[i].y)].cast<double>();
    const auto before = view.projector.project(center + direction);
    const auto after = view.projector.project(center + rotation * direction);
    if (!before || !after) {
      return image;
    }
    from[i] = {static_cast<float>(before->x()), static_cast<float>(before->y())};
    to[i] = {static_cast<float>(after->x()), static_cast<float>(after->y())};
  }
  cv::Mat result;
  cv::warpPerspective(image, result, cv::getPerspectiveTransform(from.data(), to.data()),
                      image.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return result;
}

} // namespace dewpoint::simulation
