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

/// Line in an image: pixels (column, row), possibly outside the image. Where the lens bends the
/// line, neighboring points are close enough to be connected by straight segments.
using ImageLine = std::vector<Eigen::Vector2d>;

/// Returns the twelve edges of a box, each from corner to corner. World frame, meters.
std::array<std::pair<Eigen::Vector3d, Eigen::Vector3d>, 12> edgesOf(const WorldBox& box);

/// Projects the straight line between two world points (meters). Some parts of the line are left
/// out: parts behind the camera, parts beyond the angle at which the lens model folds back
/// (Projector::project()), and parts more than 10,000 pixels away from the image. If such parts lie
/// between visible parts, the result has several pieces.
std::vector<ImageLine> projectLine(const Projector& projector, const Eigen::Vector3d& from,
                                   const Eigen::Vector3d& to);
/// Projects the twelve edges of a box like projectLine(), and returns the pieces of all edges.
std::vector<ImageLine> projectEdges(const Projector& projector, const WorldBox& box);
/// Projects a ray like projectLine(), up to 1000 m from the origin of the ray. If the ray belongs
/// to a pixel of another camera, the result is the epipolar line of that pixel.
std::vector<ImageLine> projectRay(const Projector& projector, const Ray& ray);

} // namespace dewpoint::geometry
