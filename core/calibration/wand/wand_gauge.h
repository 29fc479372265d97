// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/wand/wand_calibration.h"
#include "core/geometry/similarity.h"

#include <Eigen/Core>

namespace dewpoint::calibration {

/// Returns the similarity that maps the positions and axes of one rig's cameras to those of another
/// rig.
Similarity fitRigSimilarity(const CameraRig& from, const CameraRig& to, bool sized);

/// Transforms the cameras, states and covariance of a result to another world frame.
void moveWorld(const Similarity& change, BundleResult& result);

/// Returns the mean position of ball `ball` within a tenth of a second of `time`, or nothing if the
/// ball was not seen.
std::optional<Eigen::Vector3d> ballPositionAt(const BundleResult& now, double time,
                                              std::size_t ball = 0);

/// Scale factor determined from the scale source of the problem, with its relative standard
/// deviation. The factor is 1 for the stick (the adjustment already uses its length) and for the
/// initial rig.
struct ScaleEstimate {
  double factor = 1.0;
  double sigma = 0.0;
};
/// Determines the scale factor of a solution from the scale source of the problem.
Result<ScaleEstimate> estimateScale(const WandProblem& problem, const BundleProblem& bundle,
                                    const BundleResult& now);

/// Returns the change of the world frame (already metric) based on the floor touches or the fall;
/// the identity if there are neither. Stores its findings in `result`.
Result<Similarity> uprightWorld(const WandProblem& problem, const BundleResult& now,
                                WandResult& result);

} // namespace dewpoint::calibration
