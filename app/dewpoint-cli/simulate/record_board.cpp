// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/simulate/record_board.h"

#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/progress.h"
#include "core/calibration/board/board.h"
#include "core/calibration/board/board_picture.h"
#include "core/calibration/formats/calibration_file.h"
#include "core/capture/frame_writer.h"
#include "core/geometry/projector.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace dewpoint::app {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kBoardFramesPerSecond = 15.0;
constexpr int kFramesAtRest = 5; ///< so long each position is shown
constexpr int kBoardSamples = 3; ///< rays per pixel and direction
constexpr double kMarginPx = 12.0;

/// How the board is tilted at one position after the other, about its x and y, radians.
constexpr std::array<std::array<double, 2>, 5> kTiltCount{
    {{0.0, 0.0}, {0.5, 0.0}, {-0.5, 0.0}, {0.0, 0.5}, {0.0, -0.5}}};

/// The world is that of the board on the floor: X along its columns, Z up, meters.
CameraRig camerasAroundTheBoard() {
  const Vector3d aim(0.1, -0.05, 0.15);
  CameraRig cameras(2);
  cameras[0].name = "left";
  cameras[0].intrinsics = {640, 480, 544.0, 544.0, 317.0, 244.0};
  cameras[0].distortion = {-0.18, 0.06, 0.001, -0.0008, 0.0};
  cameras[0].cameraFromWorld = lookAt({-0.12, -0.62, 0.58}, aim);
  cameras[1].name = "right";
  cameras[1].intrinsics = {640, 480, 560.0, 560.0, 322.0, 238.0};
  cameras[1].distortion = {-0.15, 0.04, -0.0006, 0.0009, 0.0};
  cameras[1].cameraFromWorld = lookAt({0.36, -0.64, 0.54}, aim);
  return cameras;
}

/// Camera from board, for a board that faces the camera with its middle at `middle`, tilted.
Isometry3d facing(const BoardDescription& board, const Vector3d& middle,
                  const std::array<double, 2>& tilt) {
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() = (Eigen::AngleAxisd(tilt[0], Vector3d::UnitX()) *
                   Eigen::AngleAxisd(tilt[1], Vector3d::UnitY()))
                      .toRotationMatrix();
  pose.translation() = middle - pose.linear() * board.center();
  return pose;
}

/// Whether a camera sees all squares of the board, and a little of what is around them.
bool seesWhole(const Camera& camera, const BoardDescription& board,
               const Isometry3d& cameraFromBoard) {
  Camera placed = camera;
  placed.cameraFromWorld = cameraFromBoard;
  const Projector projector(placed);
  const Vector3d half(0.5 * board.squareColumns() * board.squareSize,
                      0.5 * board.squareRows() * board.squareSize, 0.0);
  for (const auto& [x, y] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {-1.0, 1.0}, {1.0, 1.0}}) {
    const auto pixel =
        projector.project(board.center() + Vector3d(x * half.x(), y * half.y(), 0.0));
    if (!pixel || pixel->x() < kMarginPx || pixel->y() < kMarginPx ||
        pixel->x() > camera.intrinsics.width - kMarginPx ||
        pixel->y() > camera.intrinsics.height - kMarginPx) {
      return false;
    }
  }
  return true;
}

/// World from board, position after position: on the floor, then all over the image of each camera,
/// then where both see it.
std::vector<Isometry3d> shownPositions(const BoardDescription& board, const CameraRig& cameras) {
  std::vector<Isometry3d> positions{calibration::worldFromFlatBoard()};
  Camera between = cameras[0];
  between.cameraFromWorld = lookAt({0.1, -0.75, 0.52}, {0.1, -0.05, 0.15});
  std::size_t number = 0;
  for (const Camera& camera : {cameras[0], cameras[1], between}) {
    for (int region = 0; region < 9; ++region, ++number) {
      const double depth = number % 3 == 0 ? 0.42 : 0.6;
      const int column = region % 3 - 1;
      const int row = region / 3 - 1;
      const Vector3d aside(0.35 * column, 0.28 * row, 0.0);
      for (double share = 1.0; share > 0.1; share *= 0.85) { // as far out as it is seen whole
        const Vector3d middle = depth * (Vector3d::UnitZ() + share * aside);
        const Isometry3d pose = facing(board, middle, kTiltCount.at(number % kTiltCount.size()));
        if (seesWhole(camera, board, pose)) {
          positions.push_back(camera.cameraFromWorld.inverse() * pose);
          break;
        }
      }
    }
  }
  return positions;
}

Status writeBoardVideo(const BoardDescription& board, const Camera& camera,
                       const std::vector<Isometry3d>& positions, std::int64_t frames,
                       const std::string& file) {
  auto writer = FrameWriter::createVideo(file, kBoardFramesPerSecond);
  if (!writer) {
    return tl::make_unexpected(writer.error());
  }
  cv::Mat color;
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    if (frame % kFramesAtRest == 0) {
      const Isometry3d& position = positions.at(static_cast<std::size_t>(frame / kFramesAtRest));
      cv::cvtColor(
          calibration::renderBoard(board, camera, camera.cameraFromWorld * position, kBoardSamples),
          color, cv::COLOR_GRAY2BGR);
    }
    if (const auto written = writer->write(color); !written) {
      return written;
    }
  }
  return writer->finish();
}

} // namespace

int recordBoard(const std::filesystem::path& folder, std::optional<std::int64_t> frames,
                const std::string& option) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) {
    return reportError({ErrorCode::FileUnwritable, folder.string(), option, problem.message()});
  }
  const BoardDescription board; // chessboard:9x6:0.025
  const CameraRig cameras = camerasAroundTheBoard();
  const auto positions = shownPositions(board, cameras);
  const auto all = static_cast<std::int64_t>(positions.size()) * kFramesAtRest;
  const std::int64_t count = std::min(frames.value_or(all), all);
  Progress progress("rendering", static_cast<std::int64_t>(cameras.size()));
  std::int64_t done = 0;
  for (const Camera& camera : cameras) {
    const auto written = writeBoardVideo(board, camera, positions, count,
                                         (folder / (camera.name + ".mkv")).string());
    if (!written) {
      progress.finish();
      return reportError(written.error());
    }
    progress.show(++done);
  }
  progress.finish();
  if (const auto written = saveCalibration(cameras, folder / "truth.toml"); !written) {
    return reportError(written.error());
  }
  fmt::print("{}: {} frames of {} cameras, truth.toml; the board is {}, on the floor in frame 0\n",
             folder.string(), count, cameras.size(), calibration::boardText(board));
  return kExitDone;
}

} // namespace dewpoint::app
