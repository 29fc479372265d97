// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projector.h"
#include "core/simulation/room/room.h"

#include <opencv2/core.hpp>

#include <array>
#include <vector>

namespace dewpoint::simulation {

/// Returns the center of a subpixel, as an offset (right, down) from the pixel center in pixels.
/// The pixel is divided into `side` x `side` equal subpixels, and `sample` is the number of the
/// subpixel, counted row by row from 0.
std::array<float, 2> subpixelOffset(int sample, int side);

/// Camera view of a room at rest: everything that does not change from frame to frame. All arrays
/// have one entry per pixel, row by row.
struct RoomView {
  RoomView(const Camera& camera, const Room& room);

  std::size_t pixelIndex(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }
  /// Returns the unit direction (world frame) of the ray through the image point that lies `right`
  /// and `down` pixels from the center of a pixel. The result is a first-order approximation.
  Vector3f rayDirection(int column, int row, float right, float down) const;
  /// Returns the pixels that can show a sphere (world, meters): the bounding box of the sphere's
  /// silhouette, clipped to the image.
  cv::Rect boundsOfSphere(const Eigen::Vector3d& center, double radius) const;

  Projector projector;
  int width = 0;
  int height = 0;
  Vector3f center; ///< optical center, world frame, meters
  /// Unit vectors of the rays, world frame; zero at pixels for which the lens model has no ray.
  std::vector<Vector3f> directions;
  std::vector<float> distances; ///< distance to the room at rest along the ray, meters
  std::vector<float>
      lampFractions;  ///< fraction of the pixel's light that comes directly from the lamp
  cv::Mat background; ///< image of the room at rest: CV_32FC3, BGR, [0, 255]

private:
  void castRays(const Camera& camera);
  void renderRoom(const Room& room);
};

} // namespace dewpoint::simulation
