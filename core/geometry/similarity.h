// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::geometry {

/// Similarity transform of world coordinates: new = scale * rotation * old + translation.
struct Similarity {
  double scale = 1.0;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const {
    return scale * (rotation * point) + translation;
  }
  /// Returns the transform that applies `first`, then this transform.
  Similarity operator*(const Similarity& first) const {
    return {scale * first.scale, rotation * first.rotation, *this * first.translation};
  }
};

/// Returns the least-squares similarity that maps each point in `from` to the point with the same
/// index in `to` (Umeyama 1991). The scale is estimated if `scaleFree` is set; otherwise it is 1.
/// Requires at least three points that are not on a line.
Similarity fitSimilarity(const std::vector<Eigen::Vector3d>& from,
                         const std::vector<Eigen::Vector3d>& to, bool scaleFree);

/// Returns the same camera in another world frame: its position and orientation are mapped by
/// `change`.
Camera transformed(const Similarity& change, Camera camera);

} // namespace dewpoint::geometry
