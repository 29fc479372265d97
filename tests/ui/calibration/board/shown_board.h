// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_picture.h"
#include "core/capture/frame_source.h"
#include "core/capture/frame_writer.h"
#include "core/project/project.h"
#include "core/project/project_save.h"
#include "core/tracking/catalog/method_catalog.h"
#include "tests/calibration/board_scene.h"

#include <opencv2/imgproc.hpp>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <thread>
#include <vector>

namespace dewpoint::tests::test {

/// Two cameras and a ChArUco board that somebody shows them.
struct ShownBoard {
  static constexpr int kPlaces = 16;

  BoardDescription board = parseBoard("charuco:7x5:0.03:0.022:DICT_4X4_50").value();
  CameraRig cameras;

  explicit ShownBoard(int width = 400, int height = 300) {
    for (int k = 0; k < 2; ++k) {
      Camera camera = testCamera(width, height);
      camera.name = k == 0 ? "left" : "right";
      camera.cameraFromWorld.translation().x() = k == 0 ? 0.0 : -0.1;
      cameras.push_back(camera);
    }
  }

  /// The board at a place: around the image, near and far, tilted to all sides.
  Eigen::Isometry3d place(int number) const {
    static constexpr std::array<std::array<double, 2>, 5> kTiltCount{
        {{0.0, 0.0}, {0.5, 0.0}, {-0.5, 0.0}, {0.0, 0.5}, {0.0, -0.5}}};
    const auto& tilt = kTiltCount.at(static_cast<std::size_t>(number % 5));
    const double depth = number % 4 == 3 ? 0.32 : 0.45;
    const double x = 0.1 * ((number * 2) % 3 - 1) + 0.05;
    const double y = 0.06 * ((number * 5) % 3 - 1);
    return boardAt(board, {x, y, depth}, tilt[0], tilt[1]);
  }

  cv::Mat picture(std::size_t camera, int number) const {
    cv::Mat color;
    cv::cvtColor(renderBoard(board, cameras[camera],
                             cameras[camera].cameraFromWorld * place(number % kPlaces), 3),
                 color, cv::COLOR_GRAY2BGR);
    return color;
  }

  /// A project that knows nothing of its cameras but the size of their images.
  Project project() const {
    Project unknown;
    unknown.name = "board";
    unknown.parameters = ParameterValues(methodParameters(unknown.method));
    for (const Camera& camera : cameras) {
      ProjectCamera one;
      one.camera.name = camera.name;
      one.camera.intrinsics = guessed(camera.intrinsics);
      one.source = SourceKind::Video;
      one.location = camera.name + ".mkv";
      unknown.cameras.push_back(one);
    }
    return unknown;
  }

  /// Records left.mkv, right.mkv and board.toml. False when they cannot be written.
  bool record(const std::filesystem::path& folder, int frames = kPlaces) const {
    for (std::size_t k = 0; k < cameras.size(); ++k) {
      auto writer = FrameWriter::createVideo((folder / (cameras[k].name + ".mkv")).string(), 30.0);
      for (int frame = 0; writer && frame < frames; ++frame) {
        if (!writer->write(picture(k, frame))) {
          return false;
        }
      }
      if (!writer || !writer->finish()) {
        return false;
      }
    }
    return saveProject(project(), folder / "board.toml").has_value();
  }

private:
  static Intrinsics guessed(const Intrinsics& known) {
    return {known.width,       known.height,      1.0 * known.width,
            1.0 * known.width, 0.5 * known.width, 0.5 * known.height};
  }
};

/// Live cameras before which the board is held at a place until it is moved on.
class LiveBoard final : public FrameSetSource {
public:
  LiveBoard(const ShownBoard& shown, std::shared_ptr<std::atomic<int>> place)
      : place_(std::move(place)) {
    for (int number = 0; number < ShownBoard::kPlaces; ++number) {
      auto& at = pictures_.emplace_back();
      for (std::size_t k = 0; k < shown.cameras.size(); ++k) {
        at.push_back(shown.picture(k, number));
      }
    }
  }

  std::optional<std::int64_t> frameCount() const override { return std::nullopt; }
  double framesPerSecond() const override { return 30.0; }
  Status seek(std::int64_t) override { return {}; }
  Result<FrameSetPtr> next() override {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    auto set = std::make_shared<FrameSet>();
    set->index = index_++;
    set->time = timeStamp(static_cast<double>(set->index) / 10.0); // slow: tests do not wait long
    for (const cv::Mat& picture :
         pictures_[static_cast<std::size_t>(*place_ % ShownBoard::kPlaces)]) {
      set->frames.push_back(
          std::make_shared<const Frame>(Frame{set->index, set->time, picture.clone()}));
    }
    return set;
  }

private:
  std::shared_ptr<std::atomic<int>> place_;
  std::vector<std::vector<cv::Mat>> pictures_;
  std::int64_t index_ = 0;
};

} // namespace dewpoint::tests::test
