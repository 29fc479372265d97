// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"
#include "core/geometry/camera.h"
#include "core/observation/people/body_silhouette.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// A gray room with four cameras in which flat bodies stand exactly where the product expects the
/// pixels of somebody there.
namespace dewpoint::tests::bodies {

inline constexpr double kRate = 15.0; ///< frames per second
inline constexpr double kHeight = 1.72;
/// On the grid of 0.2 m around the middle of the area.
inline const Eigen::Vector2d kPlace(0.4, -0.2);

inline CameraRig room() {
  CameraRig rig;
  for (const auto& corner : {std::array{-3.0, -3.0}, {3.0, -3.0}, {3.0, 3.0}, {-3.0, 3.0}}) {
    Camera camera;
    camera.name = "camera " + std::to_string(rig.size() + 1);
    camera.intrinsics = {320, 240, 230.0, 230.0, 159.5, 119.5};
    camera.cameraFromWorld = lookAt({corner[0], corner[1], 2.4}, {0.0, 0.0, 0.8});
    rig.push_back(camera);
  }
  return rig;
}

inline cv::Mat backgroundImage() {
  return {240, 320, CV_8UC3, cv::Scalar(120, 125, 130)};
}

inline std::vector<cv::Mat> backgroundImages(const CameraRig& rig) {
  std::vector<cv::Mat> rooms;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    rooms.push_back(backgroundImage());
  }
  return rooms;
}

/// Everybody stands at a place of the floor, x and y in meters.
inline FrameSetPtr draw(const CameraRig& rig, std::int64_t frame,
                        const std::vector<Eigen::Vector2d>& people) {
  FrameSet set{frame, timeStamp(static_cast<double>(frame) / kRate), {}};
  for (const Camera& camera : rig) {
    cv::Mat image = backgroundImage();
    const SilhouetteProjector maker(camera);
    for (const Eigen::Vector2d& place : people) {
      for (const cv::Rect& piece : maker.project(place, 0.0, kHeight).partRects) {
        image(piece & cv::Rect(0, 0, image.cols, image.rows)).setTo(cv::Scalar(190, 70, 40));
      }
    }
    set.frames.push_back(std::make_shared<const Frame>(Frame{frame, set.time, image}));
  }
  return std::make_shared<const FrameSet>(std::move(set));
}

} // namespace dewpoint::tests::bodies
