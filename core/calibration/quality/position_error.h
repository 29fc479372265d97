// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::calibration {

/// First-order propagation of camera errors to triangulated positions.
struct PositionErrors {
  std::vector<Eigen::Vector3d> positions; ///< meters
  Eigen::MatrixXd fromCameras;        ///< Jacobian: 3 times positions x columns of the covariance
  std::vector<Eigen::Matrix3d> noise; ///< covariance of one measurement, for a pixel sigma of 1
};

/// Computes the propagation at up to `most` positions spread over those of the result. Positions
/// that fewer than two cameras see are left out. Time offsets have no effect: the target is at
/// rest.
PositionErrors propagateToPositions(const BundleProblem& problem, const BundleResult& result,
                                    std::size_t most);

/// Removes the common rigid motion (and, with `sizeToo`, change of size) from stacked position
/// errors, column by column.
Eigen::MatrixXd removeRigidMotion(const std::vector<Eigen::Vector3d>& positions,
                                  const Eigen::MatrixXd& errors, bool sizeToo);

/// Relative change of size in stacked position errors, column by column.
Eigen::RowVectorXd sizeChange(const std::vector<Eigen::Vector3d>& positions,
                              const Eigen::MatrixXd& errors);

/// Difference `to` minus `from` of the camera parameters in the given columns (rotations, centers,
/// intrinsics, offsets).
Eigen::VectorXd cameraDifference(const std::vector<CameraColumn>& columns, const BundleResult& from,
                                 const BundleResult& to);

} // namespace dewpoint::calibration
