// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"

#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::geometry {

/// Which surface of the room a reference grid lies on.
enum class GridKind {
  Floor, ///< its x and y
  Wall,  ///< its x and z
  Box    ///< floor and the two walls that meet in the origin, and the box's edges
};

/// A grid of known size in the world, to be laid over the real surface in the images (Barrera,
/// Cañas and Matellán 2005 calibrate so). It begins at `origin` and reaches `size` along its own
/// axes, which are those of the world rotated by `turn` about the vertical.
struct ReferenceGrid {
  GridKind kind = GridKind::Floor;
  Eigen::Vector3d size{4.0, 4.0, 2.0}; ///< meters along x, y and z; a floor has no z, a wall no y
  double step = 0.5;                   ///< meters between lines
  Eigen::Vector3d origin{-2.0, -2.0, 0.0}; ///< world, meters
  double turn = 0.0;                       ///< radians, counterclockwise from above

  bool operator==(const ReferenceGrid&) const = default;

  Eigen::Isometry3d worldFromGrid() const;
  /// World position of the grid's center, meters.
  Eigen::Vector3d center() const;
};

/// Most lines along one side.
inline constexpr int kMostGridLines = 200;

/// BadValue with the field (`size`, `step`, `origin`) of a grid that cannot be drawn.
Status checkGrid(const ReferenceGrid& grid);

enum class GridRole { Line, Border, AxisX, AxisY, AxisZ };

/// One straight line of a grid: world, meters.
struct GridLine {
  GridRole role = GridRole::Line;
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
};
std::vector<GridLine> gridLines(const ReferenceGrid& grid);

/// A text at a position: the name of an axis, or meters along it.
template <int Dimension> struct GridText {
  GridRole role = GridRole::Line;
  Eigen::Matrix<double, Dimension, 1> at;
  std::string text;
};
std::vector<GridText<3>> gridLabels(const ReferenceGrid& grid);

/// A line as one image shows it: pixels, cut at the border of the image, bent by the lens (less
/// than 0.2 px beside the true curve).
struct GridStroke {
  GridRole role = GridRole::Line;
  std::vector<Eigen::Vector2d> points;
};

struct ProjectedGrid {
  std::vector<GridStroke> strokes; ///< lines first, borders and axes last, to be drawn on top
  std::vector<GridText<2>> labels; ///< inside the image
};

/// What a camera sees of a grid; nothing that is behind it or past where its lens model holds.
ProjectedGrid projectGrid(const Camera& camera, const ReferenceGrid& grid);

/// The world point of the grid that is meant by a pixel: the crossing of lines within `reach`
/// pixels, else what the ray meets on the grid's surfaces, else the point of the ray as far away as
/// the grid's center. Nothing where the camera has no ray.
std::optional<Eigen::Vector3d> gridPointAt(const Camera& camera, const ReferenceGrid& grid,
                                           const Eigen::Vector2d& pixel, double reach);

} // namespace dewpoint::geometry
