// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projector.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace dewpoint::geometry {

/// Convex polyhedron in the world frame, meters. `faces` are triangles of indices into `vertices`,
/// counterclockwise as seen from outside. There are no faces if the points lie in one plane.
struct ConvexHull {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> faces;

  /// Returns the volume in m³, or 0 without faces.
  double volume() const;
  bool empty() const { return vertices.empty(); }
};

/// Computes the convex hull of points by incremental insertion (de Berg et al. 2008, "Computational
/// Geometry", chapter 11). The function is intended for up to a few thousand points, because it
/// searches all faces for each point. Vertices keep the order of the points. A point is taken to
/// lie on a face if its distance to the face is at most 1e-9 times the size of the point cloud.
/// Points in one plane give vertices without faces.
ConvexHull convexHull(const std::vector<Eigen::Vector3d>& points);

/// Computes the convex hull of points in a plane (Andrew's monotone chain, 1979). The corners are
/// counterclockwise (x to the right, y up), and no three corners lie on a line. Up to two points
/// are returned unchanged.
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points);

/// Returns the outline of a hull in a camera's image, in pixels. The outline may extend outside the
/// image. It is computed as the convex hull of the projected vertices, which is exact for a
/// pinhole. Vertices that cannot be projected are left out.
std::vector<Eigen::Vector2d> projectedHull(const Projector& projector, const ConvexHull& hull);

} // namespace dewpoint::geometry
