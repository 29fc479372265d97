// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_picture.h"
#include "core/capture/recording.h"
#include "core/setup/calibration/board_search.h"
#include "tests/calibration/board_views.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace dewpoint::tests {

/// The board that a ShownRecording shows.
inline constexpr const char* kShown = "charuco:7x5:0.03:0.0225:DICT_4X4_50";
/// The same board with the length of a requested one, because images do not show lengths.
inline constexpr const char* kRight = "charuco:7x5:0.025:0.01875:DICT_4X4_50";

/// Two cameras; the images of the second are mirrored if wanted.
struct ShownRecording {
  explicit ShownRecording(int frames, bool secondMirrored = false) {
    const BoardDescription board = boardOf(kShown);
    for (int k = 0; k < 2; ++k) {
      ProjectCamera camera;
      camera.camera = testCamera(480, 360);
      camera.camera.name = k == 0 ? "left" : "right";
      project.cameras.push_back(camera);
      RecordedCamera one;
      one.name = camera.camera.name;
      one.kind = RecordedCamera::Kind::Generated;
      one.generatedFrameCount = frames;
      std::vector<cv::Mat> images; // drawn once: drawing takes longer than the search
      for (const auto& pose :
           variedPoses(board, camera.camera, 5, 4 + static_cast<std::uint64_t>(k))) {
        cv::Mat& image = images.emplace_back(renderBoard(board, camera.camera, pose, 2));
        if (k == 1 && secondMirrored) {
          cv::flip(image.clone(), image, 1);
        }
        cv::cvtColor(image.clone(), image, cv::COLOR_GRAY2BGR);
      }
      one.generate = [images](std::int64_t frame) {
        return images[static_cast<std::size_t>(frame % 5)].clone();
      };
      recorded.push_back(one);
    }
  }

  std::unique_ptr<FrameSetSource> open() const {
    return std::move(openRecording(recorded, 30.0).value());
  }

  Project project;
  std::vector<RecordedCamera> recorded;
};

/// Options of a calibration with the board of this text (parseBoard()).
inline BoardCalibrationRequest requestFor(const char* board) {
  BoardCalibrationRequest request;
  request.board = boardOf(board);
  return request;
}

} // namespace dewpoint::tests
