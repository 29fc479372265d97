// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projector.h"
#include "core/simulation/room/room.h"

#include <opencv2/core.hpp>

#include <array>
#include <vector>

namespace dewpoint::simulation {

/// Center of the `sample`-th of side x side equal parts of a pixel, row by row: right and down from
/// the pixel's own center, in pixels.
std::array<float, 2> subpixel(int sample, int side);

/// What one camera sees of a room at rest: everything that does not change from frame to frame. All
/// arrays are row by row, one entry per pixel.
struct RoomView {
  RoomView(const Camera& camera, const Room& room);

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }
  /// Unit direction in the world through a point of the image, to first order around a pixel.
  Vector3f direction(int column, int row, float right, float down) const;
  /// The pixels that can show a sphere: its silhouette's bounds, cut by the image.
  cv::Rect boundsOfSphere(const Eigen::Vector3d& center, double radius) const;

  Projector projector;
  int width = 0;
  int height = 0;
  Vector3f center;                  ///< world, meters
  std::vector<Vector3f> directions; ///< unit vectors, world; zero where the lens shows nothing
  std::vector<float> distances;     ///< to the room at rest along the ray, meters
  std::vector<float> lit;           ///< share of the pixel's light that comes from the lamp
  cv::Mat background;               ///< CV_32FC3, BGR, [0, 255]

private:
  void castRays(const Camera& camera);
  void seeRoom(const Room& room);
};

} // namespace dewpoint::simulation
