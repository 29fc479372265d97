// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"

#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::geometry {

/// Surface of the room on which a reference grid lies.
enum class GridKind {
  Floor, ///< plane along x and y
  Wall,  ///< plane along x and z
  Box    ///< the floor, the two walls that meet at the origin, and the edges of the box
};

/// Grid of known size in the world, drawn over the real surface in the images (the calibration
/// method of Barrera, Cañas and Matellán 2005). The grid starts at `origin` and extends by `size`
/// along its own axes, which are the world axes rotated by `rotationAngle` about the vertical.
struct ReferenceGrid {
  GridKind kind = GridKind::Floor;
  Eigen::Vector3d size{4.0, 4.0,
                       2.0}; ///< size along x, y and z, meters; floors ignore z, walls ignore y
  double step = 0.5;         ///< distance between lines, meters
  Eigen::Vector3d origin{-2.0, -2.0, 0.0}; ///< world frame, meters
  double rotationAngle = 0.0; ///< rotation in radians, counterclockwise as seen from above

  bool operator==(const ReferenceGrid&) const = default;

  /// Returns the grid pose in the world, meters.
  Eigen::Isometry3d worldFromGrid() const;
  /// Returns the world position of the grid's center, meters.
  Eigen::Vector3d center() const;
};

/// Maximum number of grid lines along one side of a grid.
inline constexpr int kMaxGridLines = 200;

/// Checks whether a grid can be drawn. The error is BadValue and names the field (`size`, `step`,
/// `origin`).
Status checkGrid(const ReferenceGrid& grid);

/// Role of a line or text in a grid. The role determines the color and line width for drawing.
enum class GridRole { Line, Border, AxisX, AxisY, AxisZ };

/// Straight line of a grid. World frame, meters.
struct GridLine {
  GridRole role = GridRole::Line;
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
};
/// Returns the lines of a grid.
std::vector<GridLine> gridLines(const ReferenceGrid& grid);

/// Text label of a grid: the name of an axis, or a distance in meters along an axis. `at` is a
/// world position in meters if `Dimension` is 3, and a pixel if `Dimension` is 2.
template <int Dimension> struct GridText {
  GridRole role = GridRole::Line;
  Eigen::Matrix<double, Dimension, 1> at;
  std::string text;
};
/// Returns the axis names and distance labels of a grid, at world positions (meters).
std::vector<GridText<3>> gridLabels(const ReferenceGrid& grid);

/// Grid line as it appears in one image, bent by the lens and clipped at the image border. The line
/// through `points` (pixels) deviates by less than 0.2 px from the true curve.
struct GridStroke {
  GridRole role = GridRole::Line;
  std::vector<Eigen::Vector2d> points;
};

/// Grid as it appears in one image.
struct ProjectedGrid {
  std::vector<GridStroke> strokes; ///< lines first; borders and axes last, to be drawn on top
  std::vector<GridText<2>> labels; ///< axis names and distances at pixels inside the image
};

/// Projects a grid into a camera. Parts behind the camera or beyond the valid range of the lens
/// model are left out.
ProjectedGrid projectGrid(const Camera& camera, const ReferenceGrid& grid);

/// Returns the intersection of grid lines (world frame, meters) that is nearest to `pixel` in the
/// image, or nothing if no intersection is within `reach` pixels.
std::optional<Eigen::Vector3d> gridCrossingAt(const Camera& camera, const ReferenceGrid& grid,
                                              const Eigen::Vector2d& pixel, double reach);

/// Returns the world point (meters) that the user means by a click at `pixel`, or nothing if the
/// lens model has no ray for the pixel. The point is the first of these that exists:
/// - the nearest intersection of grid lines within `reach` pixels
/// - the point where the pixel's ray meets a surface of the grid
/// - the point on the ray at the distance of the grid's center
std::optional<Eigen::Vector3d> gridPointAt(const Camera& camera, const ReferenceGrid& grid,
                                           const Eigen::Vector2d& pixel, double reach);

} // namespace dewpoint::geometry
