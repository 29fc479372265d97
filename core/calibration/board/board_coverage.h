// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace dewpoint::calibration {

/// How a board stands before a camera, by what of it is nearer.
enum class BoardTilt { Flat, LeftNear, RightNear, TopNear, BottomNear };

/// Flat below 15 degrees, else by the larger part of the tilt.
BoardTilt tiltOf(const Eigen::Isometry3d& cameraFromBoard);

/// Angle between the board's normal and the direction from the camera to it; radians.
double tiltAngle(const Eigen::Isometry3d& cameraFromBoard, const Eigen::Vector3d& middle);

/// Where in the image corners were seen, and at which tilts the board: a calibration says nothing
/// about regions without corners, and focal length and distance cannot be told apart without tilt.
struct BoardCoverage {
  static constexpr int kColumns = 6;
  static constexpr int kRows = 4;
  static constexpr int kTilts = 5;

  std::array<int, std::size_t{kColumns} * kRows>
      corners{};                   ///< corners seen in each region, row by row
  std::array<int, kTilts> tilts{}; ///< views at each BoardTilt

  /// The region of a pixel of an image of that size.
  static int regionOf(const Eigen::Vector2d& pixel, int width, int height);
  void add(const std::vector<Eigen::Vector2d>& pixels, BoardTilt tilt, int width, int height);
  /// The part of the regions in which a corner was seen.
  double imagePart() const;
};

} // namespace dewpoint::calibration
