// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <vector>

namespace dewpoint::calibration {

/// Returns the cameras as they are before the adjustment if the states from `first` to before `end`
/// are left out. Needed if the intrinsics were estimated from the same images: they then depend on
/// these states, too.
using CamerasWithout = std::function<CameraRig(std::size_t first, std::size_t end)>;

/// Solutions of an adjustment, each without one block of neighboring states.
struct BlockJackknife {
  std::vector<CameraRig> rigs; ///< cameras of each solution, in the gauge of the whole solution
  double squares = 0.0; ///< sum of the squared reprojection errors of the states left out, pixels²
  std::size_t points = 0; ///< number of these image points

  /// Factor by which the deviations of the solutions from their mean are multiplied, so that the
  /// sum of their squares is a variance that 1.96 standard deviations bound with 95 %: the factor
  /// of the delete-one jackknife, (G - 1) / G, and Student's t for G - 1 degrees of freedom instead
  /// of the normal distribution. 0 if there are fewer than four solutions.
  double factor() const;
};

/// Repeats an adjustment without each of at most ten blocks of neighboring states (delete-a-group
/// jackknife: Efron & Stein 1981; Kott 2001). Errors that neighboring states share, such as those
/// of delayed images or of a lens that does not fit in one part of the image, are left out as a
/// whole, so the scatter of the solutions contains them. A solution that cannot be found is left
/// out. States that are `fixed` always take part.
BlockJackknife leaveOutBlocks(const BundleProblem& problem, const BundleResult& result,
                              const CamerasWithout& camerasWithout = nullptr);

/// Returns how much each position moves (3 rows for each position) if it is triangulated with the
/// cameras of each solution (columns) from the pixels at which `rig` sees it. A position that fewer
/// than two cameras see does not move.
Eigen::MatrixXd positionChanges(const std::vector<Eigen::Vector3d>& positions, const CameraRig& rig,
                                const std::vector<CameraRig>& solutions);

/// Returns the deviations of the columns from their mean, multiplied by BlockJackknife::factor().
Eigen::MatrixXd jackknifeDeviations(const Eigen::MatrixXd& changes, double factor);

/// Returns the length that a normally distributed vector with this covariance exceeds with a
/// probability of 5 %. The squared length is approximated by a scaled chi-square distribution with
/// the same mean and variance (Satterthwaite 1946), and its quantile by Wilson & Hilferty (1931).
double lengthBound95(const Eigen::Matrix3d& covariance);

} // namespace dewpoint::calibration
