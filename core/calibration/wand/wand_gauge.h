// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/wand/wand_calibration.h"
#include "core/geometry/similarity.h"

#include <Eigen/Core>

namespace dewpoint::calibration {

/// Returns the similarity that best maps the positions and axes of the cameras in `from` to those
/// in `to`. The scale is estimated if `scaleFree` is set; otherwise it is 1.
Similarity fitRigSimilarity(const CameraRig& from, const CameraRig& to, bool scaleFree);

/// Transforms the cameras, states and covariance of a result to another world frame.
void moveWorld(const Similarity& change, BundleResult& result);

/// Returns the mean of the known positions of ball `ball` between `time` - 0.1 s and `time` + 0.1
/// s, or nothing if no position is known in that period.
std::optional<Eigen::Vector3d> ballPositionAt(const BundleResult& now, double time,
                                              std::size_t ball = 0);

/// Factor by which to scale a solution, with its relative standard deviation. The factor is 1 for
/// WandScale::Stick, because the adjustment already uses the length of the stick. It is also 1 for
/// WandScale::InitialRig.
struct ScaleEstimate {
  double scaleFactor = 1.0;
  double relativeSigma = 0.0;
};
/// Determines the scale factor of a solution in the way given by WandProblem::scaleMethod.
Result<ScaleEstimate> estimateScale(const WandProblem& problem, const BundleProblem& bundle,
                                    const BundleResult& now);

/// Returns the change of the world frame after which z points up, according to the times when the
/// ball touched the floor or fell freely. If it touched the floor, the floor is then at z = 0. If
/// it did neither, returns the identity. The scale of `now` must already be correct. Stores the
/// accuracy of the floor and of the fall in `result`.
Result<Similarity> changeToUprightWorld(const WandProblem& problem, const BundleResult& now,
                                        WandResult& result);

} // namespace dewpoint::calibration
