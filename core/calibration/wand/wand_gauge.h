// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/wand/wand_calibration.h"

#include <Eigen/Geometry>

namespace dewpoint::calibration {

/// Similarity transform of the world: new = scale * rotation * old + translation.
struct Similarity {
  double scale = 1.0;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const {
    return scale * (rotation * point) + translation;
  }
};

/// Least-squares similarity (or rigid motion if `sized` is false) that maps `from` to `to` (Umeyama
/// 1991). Needs at least three points that are not on a line.
Similarity fitSimilarity(const std::vector<Eigen::Vector3d>& from,
                         const std::vector<Eigen::Vector3d>& to, bool sized);

/// Similarity that maps the positions and axes of a rig's cameras to those of another rig.
Similarity fitRigSimilarity(const CameraRig& from, const CameraRig& to, bool sized);

/// Transforms the cameras, states and covariance of a result to another world.
void moveWorld(const Similarity& change, BundleResult& result);

/// Mean position of ball `ball` within a tenth of a second of `time`; nothing if it was not seen.
std::optional<Eigen::Vector3d> ballAt(const BundleResult& now, double time, std::size_t ball = 0);

/// Scale factor from the scale source of the problem, with its relative standard deviation. The
/// factor is 1 for the stick (the adjustment already uses its length) and for the initial rig.
struct ScaleFound {
  double factor = 1.0;
  double sigma = 0.0;
};
Result<ScaleFound> scaleOf(const WandProblem& problem, const BundleProblem& bundle,
                           const BundleResult& now);

/// Change of the world (already metric) from the floor touches or the fall; the identity without
/// either. Stores its findings in `result`.
Result<Similarity> uprightWorld(const WandProblem& problem, const BundleResult& now,
                                WandResult& result);

} // namespace dewpoint::calibration
