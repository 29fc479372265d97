// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <vector>

namespace dewpoint::calibration {

/// Function that returns the cameras from which an adjustment starts if the states (target
/// positions) with indices from `first` to before `end` are left out. It is needed if the
/// intrinsics were estimated from the same images: then their initial values must be estimated
/// without the images of these states, too.
using InitialCamerasWithoutStates = std::function<CameraRig(std::size_t first, std::size_t end)>;

/// Solutions of an adjustment that was repeated, each time without one block of neighboring states.
struct BlockJackknife {
  /// Cameras of each solution, in the world frame of the solution with all states.
  std::vector<CameraRig> rigs;
  /// Sum of the squared reprojection errors of the states left out, pixels².
  double squaredErrorSum = 0.0;
  std::size_t leftOutPointCount = 0; ///< number of image points in `squaredErrorSum`

  /// Returns the factor by which to multiply the deviations of the G solutions from their mean. The
  /// sum of the squares of the products is a variance; 95 % of errors are below 1.96 times its
  /// square root. The factor combines the jackknife's sqrt((G - 1) / G) with Student's t for G - 1
  /// degrees of freedom. 0 if there are fewer than four solutions.
  double deviationScale() const;
};

/// Repeats an adjustment without each of at most ten blocks of neighboring states (delete-a-group
/// jackknife: Efron & Stein 1981; Kott 2001). Neighboring states may share errors, for example
/// because of delayed images or of a lens model that does not fit one part of the image. Such an
/// error is left out together with its block, so the scatter of the solutions includes it. A
/// repetition without a solution is skipped. States that are `isFixed` are never left out.
BlockJackknife
leaveOutBlocks(const BundleProblem& problem, const BundleResult& result,
               const InitialCamerasWithoutStates& estimateInitialCamerasWithoutStates = nullptr);

/// Returns the displacement of each position (3 rows for each position; meters) for each solution
/// (columns). The position is triangulated by the cameras of the solution, from the pixels at which
/// the cameras in `rig` see it. A position that fewer than two cameras see does not move.
Eigen::MatrixXd positionChanges(const std::vector<Eigen::Vector3d>& positions, const CameraRig& rig,
                                const std::vector<CameraRig>& solutions);

/// Returns the deviations of the columns of `changes` (one per solution) from their mean,
/// multiplied by `factor`, which is BlockJackknife::deviationScale().
Eigen::MatrixXd jackknifeDeviations(const Eigen::MatrixXd& changes, double factor);

/// Returns the length that a normally distributed vector with this covariance exceeds with a
/// probability of 5 %. The squared length is approximated by a scaled chi-square distribution with
/// the same mean and variance (Satterthwaite 1946), and its quantile by Wilson & Hilferty (1931).
double lengthBound95(const Eigen::Matrix3d& covariance);

} // namespace dewpoint::calibration
