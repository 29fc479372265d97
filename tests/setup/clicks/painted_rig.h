// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_sample.h"
#include "core/geometry/camera.h"
#include "core/geometry/sphere_image.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace dewpoint::tests {

/// The ball of most of these pictures: 15 px at 2 m.
inline const color::BgrColor kRed{40, 40, 200};
inline const Eigen::Vector3d kBall(0.1, -0.05, 0.08);
inline constexpr double kRadius = 0.1;

/// Three ideal cameras of 320 x 240 pixels and a focal length of 300 px, two meters from the origin
/// at right angles, and images of them: a gray wall on which balls are painted as discs, darker
/// toward their rims.
class PaintedRig {
public:
  explicit PaintedRig(std::size_t cameras) {
    const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& from :
         {Eigen::Vector3d(0.0, -2.0, 0.0), Eigen::Vector3d(-2.0, 0.0, 0.0),
          Eigen::Vector3d(1.4, 1.4, 0.5)}) {
      if (rig.size() < cameras) {
        Camera camera;
        camera.intrinsics = {320, 240, 300.0, 300.0, 159.5, 119.5};
        camera.cameraFromWorld = lookAt(from, origin);
        rig.push_back(camera);
        images.emplace_back(240, 320, CV_8UC3, cv::Scalar(120, 120, 120));
      }
    }
  }

  SphereImage discOf(std::size_t camera, const Eigen::Vector3d& center, double radius) const {
    return SphereProjector(rig[camera]).project(center, radius).value();
  }
  void paint(std::size_t camera, const Eigen::Vector3d& center, double radius,
             const color::BgrColor& bgr) {
    const SphereImage disc = discOf(camera, center, radius);
    constexpr int kShift = 4;
    const auto fixed = [](double value) { return static_cast<int>(std::lround(16.0 * value)); };
    for (const auto& [share, light] : {std::pair(1.0, 0.8), {0.75, 1.0}, {0.45, 1.15}}) {
      const cv::Scalar color(light * bgr[0], light * bgr[1], light * bgr[2]);
      cv::circle(images[camera], {fixed(disc.center.x()), fixed(disc.center.y())},
                 fixed(share * disc.radius), color, cv::FILLED, cv::LINE_8, kShift);
    }
  }
  void paintInAll(const Eigen::Vector3d& center, double radius, const color::BgrColor& bgr) {
    for (std::size_t camera = 0; camera < rig.size(); ++camera) {
      paint(camera, center, radius, bgr);
    }
  }
  /// What a click in the middle of a disc takes.
  color::ColorSample clickOn(std::size_t camera, const Eigen::Vector3d& center,
                             double radius) const {
    const SphereImage disc = discOf(camera, center, radius);
    color::ColorSample place;
    place.camera = static_cast<int>(camera);
    place.x = std::round(disc.center.x());
    place.y = std::round(disc.center.y());
    return color::takeSample(images[camera], place).value();
  }
  bool isOn(const color::ColorSample& sample, const Eigen::Vector3d& center, double radius) const {
    const SphereImage disc = discOf(static_cast<std::size_t>(sample.camera), center, radius);
    return std::hypot(sample.x - disc.center.x(), sample.y - disc.center.y()) <= disc.radius;
  }

  CameraRig rig;
  std::vector<cv::Mat> images;
};

} // namespace dewpoint::tests
