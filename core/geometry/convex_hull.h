// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projector.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace dewpoint::geometry {

/// A convex polyhedron. `faces` are triangles of indices into `vertices`, counterclockwise as seen
/// from outside; none when the points lie in one plane. Meters, world frame.
struct ConvexHull {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> faces;

  /// m³; 0 without faces.
  double volume() const;
  bool empty() const { return vertices.empty(); }
};

/// The convex hull of some points, by adding them one after the other (de Berg et al. 2008,
/// "Computational Geometry", chapter 11, with plain search instead of conflict lists: meant for up
/// to some thousand points). Vertices keep the order of the points. Points within 1e-9 of the
/// cloud's size of a face count as on it. Points that lie in one plane give vertices without faces.
ConvexHull convexHull(const std::vector<Eigen::Vector3d>& points);

/// The corners of the convex hull of points in a plane, counterclockwise (x to the right, y up), no
/// three on a line (Andrew's monotone chain, 1979). Up to two points are returned as they are.
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points);

/// The outline of a hull in a camera's image, pixels, also outside the image: the hull of its
/// projected vertices, which is exact for a pinhole. Vertices that the camera cannot show are left
/// out.
std::vector<Eigen::Vector2d> projectedHull(const Projector& projector, const ConvexHull& hull);

} // namespace dewpoint::geometry
