// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/wand/wand_calibration.h"

#include <Eigen/Geometry>

namespace dewpoint::calibration {

/// A change of the world: new = scale * rotation * old + translation.
struct Similarity {
  double scale = 1.0;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const {
    return scale * (rotation * point) + translation;
  }
};

/// The least-squares similarity (or rigid motion: `sized` false) that brings `from` to `to`
/// (Umeyama 1991). At least three points that are not on a line.
Similarity fitSimilarity(const std::vector<Eigen::Vector3d>& from,
                         const std::vector<Eigen::Vector3d>& to, bool sized);

/// The one that brings the cameras of a rig, positions and axes, to those of another.
Similarity fitRigSimilarity(const CameraRig& from, const CameraRig& to, bool sized);

/// The cameras, states and covariance of a result in another world.
void moveWorld(const Similarity& change, BundleResult& result);

/// The mean position of ball `ball` within a tenth of a second of a time; nothing when not seen.
std::optional<Eigen::Vector3d> ballAt(const BundleResult& now, double time, std::size_t ball = 0);

/// The factor on sizes by the scale source of the problem, with its relative standard deviation: 1
/// for the stick (it is in the adjustment) and the initial rig.
struct ScaleFound {
  double factor = 1.0;
  double sigma = 0.0;
};
Result<ScaleFound> scaleOf(const WandProblem& problem, const BundleProblem& bundle,
                           const BundleResult& now);

/// The change of world (already metric) by the floor touches or the fall, the identity without
/// either; reports what it found in `result`.
Result<Similarity> uprightWorld(const WandProblem& problem, const BundleResult& now,
                                WandResult& result);

} // namespace dewpoint::calibration
