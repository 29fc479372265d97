// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/clips/calibrated_clip.h"
#include "core/geometry/projector.h"
#include "tests/capture/temporary_folder.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <filesystem>

namespace dewpoint::tests::test {

/// Frames in the images of the small clip.
inline constexpr std::int64_t kSmallClipFrames = 12;

/// Two cameras of 160 x 120 pixels and 200 pixels of focal length, side by side, 0.2 m apart.
inline CameraRig smallRig() {
  CameraRig rig(2);
  for (std::size_t k = 0; k < 2; ++k) {
    rig[k].name = fmt::format("camera {}", k + 1);
    rig[k].intrinsics = {160, 120, 200.0, 200.0, 80.0, 60.0};
    rig[k].cameraFromWorld.translation() = Eigen::Vector3d(k == 0 ? 0.1 : -0.1, 0.0, 0.0);
  }
  return rig;
}

/// The ball's position in a frame of the images: 1 m before the cameras, 10 mm further to the right
/// each time. Its projections are whole pixels: 200 px/m * (x + 0.1 m) + 80.
inline Eigen::Vector3d smallClipPosition(std::int64_t frame) {
  return {-0.05 + 0.01 * static_cast<double>(frame), 0.02, 1.0};
}

/// Writes the images of a pink disk on gray, a folder per camera, and gives the clip of them: every
/// frame from the third on is an instant, every second instant has a truth.
inline CalibratedClip makeSmallClip(const TemporaryFolder& folder) {
  CalibratedClip clip;
  clip.name = "R1-small";
  clip.rig = smallRig();
  for (std::size_t camera = 0; camera < clip.rig.size(); ++camera) {
    const std::filesystem::path images = folder / fmt::format("camera{}", camera);
    std::filesystem::create_directories(images);
    const Projector projector(clip.rig[camera]);
    for (std::int64_t frame = 0; frame < kSmallClipFrames; ++frame) {
      cv::Mat image(120, 160, CV_8UC3, cv::Scalar::all(90));
      const auto pixel = projector.project(smallClipPosition(frame));
      cv::circle(image, {cvRound(pixel->x()), cvRound(pixel->y())}, 9, {145, 85, 245}, cv::FILLED);
      cv::imwrite((images / fmt::format("{:03}.png", frame)).string(), image);
    }
    clip.cameraPaths.push_back(images);
  }
  clip.instants = simultaneousInstants(2, kSmallClipFrames, 2, 30.0);
  ColorSample click; // in the first instant, frame 2: x = -0.03 m, 14 px right of the center
  click.x = 94.0;
  click.y = 64.0;
  clip.targets = {{"disk", click}};
  for (std::int64_t instant = 0; instant < kSmallClipFrames - 2; instant += 2) {
    clip.positions.push_back({instant, 0, smallClipPosition(instant + 2)});
  }
  return clip;
}

} // namespace dewpoint::tests::test
