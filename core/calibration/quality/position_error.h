// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::calibration {

/// First-order propagation of camera errors to triangulated positions.
struct PositionErrors {
  std::vector<Eigen::Vector3d> positions; ///< triangulated positions, meters
  /// Derivatives of the positions (3 rows for each) with respect to the camera parameters (columns
  /// as in the covariance of the result).
  Eigen::MatrixXd cameraJacobian;
  /// Covariance of each position due to image noise, if the position is triangulated from one image
  /// per camera and an image position has a standard deviation of 1 pixel; m².
  std::vector<Eigen::Matrix3d> noiseCovariances;
};

/// Returns all positions of the target in the result, in the world, meters. A stick counts with
/// both ends, a board with its first and its last corner.
std::vector<Eigen::Vector3d> observedPositions(const BundleProblem& problem,
                                               const BundleResult& result);

/// Returns at most `most` of the positions, taken at equal steps from the list.
std::vector<Eigen::Vector3d> chooseEvenly(const std::vector<Eigen::Vector3d>& all,
                                          std::size_t most);

/// Propagates camera errors to up to `most` positions, which are spread over the positions of the
/// target in the result. Positions seen by fewer than two cameras are left out. Time offsets have
/// no effect, because the target is assumed to be at rest.
PositionErrors propagateToPositions(const BundleProblem& problem, const BundleResult& result,
                                    std::size_t most);

/// Propagates the errors of the cameras in `result` to these positions (world, meters). Positions
/// that fewer than two cameras see are left out.
PositionErrors propagateErrorsTo(const std::vector<Eigen::Vector3d>& positions,
                                 const BundleResult& result);

/// Removes the common rigid motion from errors of positions. `errors` has three rows per position,
/// and each column is a separate set of errors. With `sizeToo`, also removes the common change of
/// size.
Eigen::MatrixXd removeRigidMotion(const std::vector<Eigen::Vector3d>& positions,
                                  const Eigen::MatrixXd& errors, bool sizeToo);

/// Finds the rigid motion that the `errors` of `positions` have in common, and removes it from
/// `errorsOfOthers`. The result shows how far `others` are displaced relative to `positions`. Both
/// matrices have three rows per position and the same columns. With `sizeToo`, also finds and
/// removes the common change of size.
Eigen::MatrixXd removeRigidMotionOf(const std::vector<Eigen::Vector3d>& positions,
                                    const Eigen::MatrixXd& errors, bool sizeToo,
                                    const std::vector<Eigen::Vector3d>& others,
                                    const Eigen::MatrixXd& errorsOfOthers);

/// Returns the relative change of size for each column of `errors`, which has three rows per
/// position.
Eigen::RowVectorXd sizeChange(const std::vector<Eigen::Vector3d>& positions,
                              const Eigen::MatrixXd& errors);

/// Returns the camera parameters of `to` minus those of `from`, in the order of `columns`
/// (rotations, centers, intrinsics, offsets).
Eigen::VectorXd cameraParameterDifference(const std::vector<CameraParameterColumn>& columns,
                                          const BundleResult& from, const BundleResult& to);

} // namespace dewpoint::calibration
