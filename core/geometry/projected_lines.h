// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/projector.h"
#include "core/geometry/ray.h"
#include "core/geometry/world_box.h"

#include <Eigen/Core>

#include <array>
#include <utility>
#include <vector>

namespace dewpoint::geometry {

/// A line in an image: pixels (column, row), also outside the image, neighbors close enough to be
/// joined by straight strokes where the lens bends it.
using ImageLine = std::vector<Eigen::Vector2d>;

/// The twelve edges of a box, from corner to corner.
std::array<std::pair<Eigen::Vector3d, Eigen::Vector3d>, 12> edgesOf(const WorldBox& box);

/// What a camera shows of the straight line between two points of the world: nothing of what is
/// behind it, beyond the fold-back of its lens (Projector::project) or 10,000 pixels off, where
/// nobody looks. Several pieces where the line leaves that part and comes back.
std::vector<ImageLine> projectedLine(const Projector& projector, const Eigen::Vector3d& from,
                                     const Eigen::Vector3d& to);
/// The same of all edges of a box.
std::vector<ImageLine> projectedEdges(const Projector& projector, const WorldBox& box);
/// The same of a ray, up to 1000 m from its origin: the epipolar line of the pixel it comes from.
std::vector<ImageLine> projectedRay(const Projector& projector, const Ray& ray);

} // namespace dewpoint::geometry
