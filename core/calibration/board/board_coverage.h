// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace dewpoint::calibration {

/// Tilt of a board relative to a camera, named after the side that is nearer to the camera.
enum class BoardTilt { Flat, LeftNear, RightNear, TopNear, BottomNear };

/// Returns the tilt of a board: Flat if the angle between the board's normal and the optical axis
/// is below 15 degrees. Otherwise, the larger one of the horizontal and the vertical tilt decides.
BoardTilt tiltOf(const Eigen::Isometry3d& cameraFromBoard);

/// Returns the angle between the board's normal and the direction from the camera to the center of
/// the board, in radians. `boardCenter` is the center of the board in the board frame.
double tiltAngle(const Eigen::Isometry3d& cameraFromBoard, const Eigen::Vector3d& boardCenter);

/// Image regions in which corners were seen, and tilts at which the board was seen. A calibration
/// has no information about regions without corners. Without views of a tilted board, a calibration
/// cannot separate the focal length from the distance of the board.
struct BoardCoverage {
  static constexpr int kColumns = 6;
  static constexpr int kRows = 4;
  static constexpr int kTiltCount = 5;

  /// Number of corners seen in each region, row by row.
  std::array<int, std::size_t{kColumns} * kRows> cornerCounts{};
  std::array<int, kTiltCount> tiltCounts{}; ///< number of views at each BoardTilt

  /// Returns the index of the region that contains a pixel, in an image of `width` x `height`
  /// pixels.
  static int regionOf(const Eigen::Vector2d& pixel, int width, int height);
  /// Adds a view with corners at `pixels`, in an image of `width` x `height` pixels.
  void add(const std::vector<Eigen::Vector2d>& pixels, BoardTilt tilt, int width, int height);
  /// Returns the fraction of regions in which a corner was seen, 0 to 1.
  double coveredFraction() const;
};

} // namespace dewpoint::calibration
