// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"
#include "core/geometry/camera.h"
#include "core/geometry/sphere_image.h"
#include "core/tracking/target.h"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>

namespace dewpoint::tests::ball {

inline constexpr double kRadius = 0.035; ///< meters
inline constexpr double kRate = 30.0;    ///< frames per second

/// Cameras around a desk; of different heights, so that no exchange of two is like another.
inline CameraRig rigOf(int count) {
  CameraRig rig;
  for (int k = 0; k < count; ++k) {
    const double angle = 0.7 * std::numbers::pi * k / std::max(1, count - 1);
    Camera camera;
    camera.name = "camera " + std::to_string(k + 1);
    camera.intrinsics = {320, 240, 350.0, 350.0, 159.5, 119.5};
    camera.cameraFromWorld =
        lookAt({1.1 * std::cos(angle), 1.1 * std::sin(angle), 0.5 + 0.12 * k}, {0.0, 0.0, 0.15});
    rig.push_back(camera);
  }
  return rig;
}

inline Target target() {
  Target red;
  red.name = "red";
  red.radius = kRadius;
  red.color = {340.0, 20.0, 0.5, 1.0, 0.1, 0.9};
  return red;
}

/// Where the ball is, meters; once round in six seconds.
inline Eigen::Vector3d place(double time) {
  const double angle = 2.0 * std::numbers::pi * time / 6.0;
  return {0.11 * std::sin(angle), 0.08 * std::sin(2.0 * angle + 1.0),
          0.15 + 0.05 * std::sin(3.0 * angle + 2.0)};
}

/// A red disc of subpixel position before a gray wall.
inline void draw(cv::Mat& image, const Camera& camera, const Eigen::Vector3d& center) {
  constexpr int kShift = 6;
  const auto fixed = [](double value) { return int(std::lround(value * (1 << kShift))); };
  if (const auto disc = SphereProjector(camera).project(center, kRadius)) {
    cv::circle(image, {fixed(disc->center.x()), fixed(disc->center.y())}, fixed(disc->radius),
               {30, 30, 220}, cv::FILLED, cv::LINE_AA, kShift);
  }
}

inline FramePtr imageOf(const Camera& camera, double shown, double stamped) {
  auto frame = std::make_shared<Frame>();
  frame->captureTime = timeStamp(stamped);
  frame->image =
      cv::Mat(camera.intrinsics.height, camera.intrinsics.width, CV_8UC3, cv::Scalar::all(100));
  draw(frame->image, camera, place(shown));
  return frame;
}

/// What the true cameras see; `lateBy`: of each camera, seconds.
inline FrameSet framesAt(std::int64_t index, const CameraRig& cameras,
                         const std::function<double(std::size_t)>& lateBy = nullptr) {
  FrameSet set;
  set.index = index;
  const double time = static_cast<double>(index) / kRate;
  set.time = timeStamp(time);
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    set.frames.push_back(imageOf(cameras[k], time - (lateBy ? lateBy(k) : 0.0), time));
  }
  return set;
}

} // namespace dewpoint::tests::ball
