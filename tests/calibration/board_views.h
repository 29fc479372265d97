// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/calibration/board/board.h"
#include "core/calibration/board/intrinsics_from_board.h"
#include "core/geometry/projector.h"
#include "tests/calibration/board_scene.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <vector>

namespace dewpoint::tests {

/// A folder of the real recordings; empty when they are not there.
inline std::filesystem::path dataFolder(const char* name) {
  const char* data = std::getenv("DEWPOINT_DATA");
  const std::filesystem::path folder = std::filesystem::path(data != nullptr ? data : "") / name;
  return data != nullptr && std::filesystem::exists(folder) ? folder : std::filesystem::path();
}

inline BoardDescription boardOf(const char* text) {
  return parseBoard(text).value();
}

/// Random poses in front of a camera, like those of a person who shows the board around.
inline std::vector<Eigen::Isometry3d>
variedPoses(const BoardDescription& board, const Camera& camera, int count, std::uint64_t seed) {
  std::vector<Eigen::Isometry3d> poses;
  const RandomStream random(seed, 0, 0, RandomPurpose::Simulation);
  const double size = (board.corner(board.cornerCount() - 1) - board.corner(0)).norm();
  for (std::uint32_t k = 0; static_cast<int>(poses.size()) < count; ++k) {
    const auto u = random.uniform3(k, 0);
    const auto v = random.uniform3(k, 1);
    const double depth = size * (1.2 + 1.3 * u[2]);
    const double reach = 0.8 * camera.intrinsics.width / (2.0 * camera.intrinsics.focalX) * depth;
    const auto pose =
        boardAt(board, {(2.0 * u[0] - 1.0) * reach, (1.5 * u[1] - 0.75) * reach, depth},
                1.4 * v[0] - 0.7, 1.4 * v[1] - 0.7, 0.8 * v[2] - 0.4);
    Camera placed = camera;
    placed.cameraFromWorld = pose;
    const Projector projector(placed);
    bool inside = true;
    for (int id = 0; id < board.cornerCount(); ++id) {
      const auto pixel = projector.project(board.corner(id));
      inside = inside && pixel && pixel->x() > 12.0 && pixel->y() > 12.0 &&
               pixel->x() < camera.intrinsics.width - 12.0 &&
               pixel->y() < camera.intrinsics.height - 12.0;
    }
    if (inside) {
      poses.push_back(pose);
    }
  }
  return poses;
}

/// All corners of a board, with Gaussian noise on each coordinate.
inline BoardView viewOf(const BoardDescription& board, const Camera& camera,
                        const Eigen::Isometry3d& cameraFromBoard, double sigmaPx,
                        std::uint32_t number) {
  const RandomStream random(77, number, 0, RandomPurpose::Noise);
  Camera placed = camera;
  placed.cameraFromWorld = cameraFromBoard;
  const Projector projector(placed);
  BoardView view;
  view.name = "view " + std::to_string(number);
  view.instant = number;
  for (int id = 0; id < board.cornerCount(); ++id) {
    const auto pixel = projector.project(board.corner(id));
    const auto noise = random.normal4(static_cast<std::uint32_t>(id));
    if (pixel && pixel->x() > 0.0 && pixel->y() > 0.0 && pixel->x() < camera.intrinsics.width &&
        pixel->y() < camera.intrinsics.height) {
      view.detection.ids.push_back(id);
      view.detection.pixels.push_back(*pixel + sigmaPx * Eigen::Vector2d(noise[0], noise[1]));
    }
  }
  return view;
}

} // namespace dewpoint::tests
