// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/board_recording.h"

#include "core/base/random.h"
#include "core/base/toml_text.h"
#include "core/calibration/board/board_picture.h"
#include "core/capture/recording.h"
#include "core/geometry/projector.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace dewpoint::bench {
namespace {

constexpr int kInstants = 60;
constexpr double kRate = 5.0;         ///< images per second
constexpr double kNoise = 2.0;        ///< gray levels
constexpr double kCornerNoise = 0.05; ///< pixels, per axis: more than the median of rendered boards
constexpr double kBend = 0.5e-3;      ///< meters, at the two edges
constexpr double kMargin = 12.0;      ///< pixels
constexpr double kBlur = 0.6;         ///< pixels
constexpr double kScatters[] = {0.0, 0.005, 0.015}; ///< seconds, at most

/// Two to five cameras on an arc, which look at the place where the board is waved.
CameraRig arcRig(std::uint64_t seed) {
  const RandomStream random(seed, 0, 0, RandomPurpose::Simulation);
  const int count = 2 + static_cast<int>(seed % 4);
  CameraRig rig;
  for (int k = 0; k < count; ++k) {
    const auto draw = random.normal4(static_cast<std::uint32_t>(k), 0);
    const auto lens = random.normal4(static_cast<std::uint32_t>(k), 1);
    Camera camera;
    camera.name = fmt::format("camera {}", k + 1);
    const double focal = 540.0 + 15.0 * lens[0];
    camera.intrinsics = {640, 480, focal, focal, 317.0 + 4.0 * lens[1], 243.0 + 4.0 * lens[2]};
    camera.distortion = {-0.18 + 0.02 * lens[3], 0.06, 0.001, -0.0008, 0.0, 0.05 * draw[3]};
    const double angle = 1.3 * (k / (count - 1.0) - 0.5) + 0.05 * draw[0];
    const double far = 1.7 + 0.1 * draw[1];
    camera.cameraFromWorld = lookAt(
        {far * std::sin(angle), -far * std::cos(angle), 1.2 + 0.2 * draw[2]}, {0.0, 0.0, 0.9});
    rig.push_back(camera);
  }
  return rig;
}

/// The camera with a lens as from another calibration, off by some 0.5 %.
Camera roughlyKnown(Camera camera, std::uint64_t seed, std::size_t number) {
  const RandomStream random(seed, static_cast<std::uint32_t>(number), 2, RandomPurpose::Simulation);
  const auto draw = random.normal4(0);
  camera.cameraFromWorld.setIdentity();
  camera.intrinsics.focalX *= 1.0 + 0.005 * draw[0];
  camera.intrinsics.focalY = camera.intrinsics.focalX;
  camera.intrinsics.centerX += 3.0 * draw[1];
  camera.intrinsics.centerY += 3.0 * draw[2];
  camera.distortion[0] += 0.01 * draw[3];
  camera.distortion[5] = 0.0; // not part of the model that is estimated
  return camera;
}

/// Where the board is: upright, toward the cameras, waved by hand.
Eigen::Isometry3d wavedBoard(const BoardDescription& board, std::uint64_t seed, double time) {
  const RandomStream random(seed, 0, 1, RandomPurpose::Simulation);
  double swing[6];
  for (std::uint32_t k = 0; k < 6; ++k) {
    const auto draw = random.uniform3(k);
    swing[k] = std::sin((0.7 + 1.1 * draw[0]) * time + 2.0 * std::numbers::pi * draw[1]);
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() =
      (Eigen::AngleAxisd(0.5 * swing[0], Eigen::Vector3d::UnitZ()) *
       Eigen::AngleAxisd(-0.5 * std::numbers::pi + 0.5 * swing[1], Eigen::Vector3d::UnitX()) *
       Eigen::AngleAxisd(0.5 * swing[2], Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  pose.translation() = Eigen::Vector3d(0.35 * swing[3], 0.35 * swing[4], 0.9 + 0.3 * swing[5]) -
                       pose.linear() * board.center();
  return pose;
}

cv::Mat photographed(cv::Mat picture, const RandomStream& random) {
  cv::GaussianBlur(picture, picture, {0, 0}, kBlur);
  for (int row = 0; row < picture.rows; ++row) {
    for (int column = 0; column < picture.cols; column += 3) {
      const auto draw = random.normal3(static_cast<std::uint32_t>(row * picture.cols + column));
      for (int k = 0; k < std::min(3, picture.cols - column); ++k) {
        auto& pixel = picture.at<unsigned char>(row, column + k);
        pixel = cv::saturate_cast<unsigned char>(pixel + kNoise * draw[k]);
      }
    }
  }
  return picture;
}

std::optional<BoardDetection> detected(const BoardDescription& board, const Camera& camera,
                                       const Eigen::Isometry3d& pose, const RandomStream& random) {
  const cv::Mat image = photographed(renderBoard(board, camera, pose, 3), random);
  return BoardDetector(board).detect(image, DetectionEffort::Live);
}

/// The corners of a board that is bent a little, as they are found in a rendered image.
std::optional<BoardDetection> projected(const BoardDescription& board, Camera camera,
                                        const Eigen::Isometry3d& pose, const RandomStream& random) {
  camera.cameraFromWorld = pose;
  const Projector projector(camera);
  const double half = 0.5 * board.squareSize * board.squareColumns();
  BoardDetection found;
  for (int id = 0; id < board.cornerCount(); ++id) {
    Eigen::Vector3d corner = board.corner(id);
    corner.z() += kBend * std::pow((corner.x() - board.center().x()) / half, 2);
    const auto pixel = projector.project(corner);
    const auto draw = random.normal4(static_cast<std::uint32_t>(id), 2);
    if (!pixel || pixel->x() < kMargin || pixel->y() < kMargin ||
        pixel->x() > camera.intrinsics.width - kMargin ||
        pixel->y() > camera.intrinsics.height - kMargin) {
      return std::nullopt; // a chessboard has to be seen whole
    }
    found.ids.push_back(id);
    found.pixels.emplace_back(*pixel + kCornerNoise * Eigen::Vector2d(draw[0], draw[1]));
  }
  found.edgeWidthPx = 1.5;
  return found;
}

std::vector<std::filesystem::path> imagesOf(const std::filesystem::path& folder,
                                            const std::string& prefix) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().filename().string().starts_with(prefix)) {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

} // namespace

BoardRecording simulatedRig(std::uint64_t seed, bool rendered) {
  BoardRecording recording;
  recording.name = fmt::format("rig {}", seed);
  recording.lensesKnown = true;
  recording.board = parseBoard("chessboard:8x5:0.05").value();
  const double scatter = kScatters[seed % std::size(kScatters)];
  const CameraRig rig = arcRig(seed);
  recording.truth = rig;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    const Intrinsics& image = rig[k].intrinsics;
    ProjectCamera& camera = recording.project.cameras.emplace_back();
    camera.camera = roughlyKnown(rig[k], seed, k);
    setup::BoardDetections::PerCamera seen;
    seen.name = rig[k].name;
    seen.imageWidth = image.width;
    seen.imageHeight = image.height;
    seen.searchedImageCount = kInstants;
    for (int i = 0; i < kInstants; ++i) {
      const RandomStream random(seed, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k),
                                RandomPurpose::Noise);
      const double time = i / kRate + scatter * (2.0 * random.uniform3(0, 1)[0] - 1.0);
      const Eigen::Isometry3d pose =
          rig[k].cameraFromWorld * wavedBoard(recording.board, seed, time);
      auto found = rendered ? detected(recording.board, rig[k], pose, random)
                            : projected(recording.board, rig[k], pose, random);
      if (found) {
        seen.views.push_back({fmt::format("frame {}", i), i, std::move(*found)});
      }
    }
    recording.seen.cameras.push_back(std::move(seen));
  }
  recording.seen.framesPerSecond = kRate;
  return recording;
}

Result<BoardRecording> charucoRecording(const std::filesystem::path& data) {
  BoardRecording recording;
  recording.name = "charuco4";
  recording.board = parseBoard("charuco:4x5:0.054:0.0405:DICT_4X4_1000:inverted").value();
  recording.lensesKnown = true;
  const auto folder = data / "charuco4";
  const auto table = readTomlFile(folder / "camera_array.toml");
  if (!table) {
    return tl::make_unexpected(table.error());
  }
  std::vector<RecordedCamera> videos;
  for (int k = 0; k < 4; ++k) {
    const auto& values = *(*table)["cameras"][std::to_string(k)].as_table();
    const auto& matrix = values["matrix"];
    ProjectCamera camera;
    camera.camera.name = fmt::format("camera {}", k);
    camera.camera.intrinsics = {1280,
                                720,
                                *matrix[0][0].value<double>(),
                                *matrix[1][1].value<double>(),
                                *matrix[0][2].value<double>(),
                                *matrix[1][2].value<double>()};
    for (std::size_t c = 0; c < 5; ++c) {
      camera.camera.distortion[c] = *values["distortions"][c].value<double>();
    }
    RecordedCamera& video = videos.emplace_back();
    video.name = camera.camera.name;
    video.path = (folder / fmt::format("cam_{}.mp4", k)).string();
    recording.project.cameras.push_back(std::move(camera));
  }
  setup::BoardCalibrationRequest request;
  request.board = recording.board;
  return openRecording(videos, 0)
      .and_then([&](const auto& source) {
        return setup::findBoards(recording.project, *source, request);
      })
      .map([&](setup::BoardDetections seen) {
        recording.seen = std::move(seen);
        return recording;
      });
}

Result<BoardRecording> trayRecording(const std::filesystem::path& data) {
  BoardRecording recording;
  recording.name = "stereo_tray";
  recording.board = parseBoard("chessboard:7x5:0.03").value();
  for (const char* side : {"left", "right"}) {
    const auto files = imagesOf(data / "stereo_tray" / "640x480", side);
    auto seen = setup::findBoards(files, recording.board, DetectionEffort::Exact);
    if (!seen) {
      return tl::make_unexpected(seen.error());
    }
    auto& camera = recording.seen.cameras.emplace_back(std::move(seen->cameras.front()));
    camera.name = side;
    auto& known = recording.project.cameras.emplace_back();
    known.camera = guessedCamera(camera.imageWidth, camera.imageHeight);
    known.camera.name = side;
  }
  return recording;
}

} // namespace dewpoint::bench
