// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::calibration {

/// First-order propagation of camera errors to triangulated positions.
struct PositionErrors {
  std::vector<Eigen::Vector3d> positions; ///< triangulated positions, meters
  Eigen::MatrixXd
      fromCameras; ///< Jacobian: 3 times the number of positions x columns of the covariance
  std::vector<Eigen::Matrix3d> noise; ///< covariance of one measurement for a pixel sigma of 1
};

/// Propagates camera errors to up to `most` positions, spread over those in the result. Positions
/// seen by fewer than two cameras are left out. Time offsets have no effect because the target is
/// assumed to be at rest.
PositionErrors propagateToPositions(const BundleProblem& problem, const BundleResult& result,
                                    std::size_t most);

/// Removes the common rigid motion from stacked position errors, column by column. With `sizeToo`,
/// also removes the common change of size.
Eigen::MatrixXd removeRigidMotion(const std::vector<Eigen::Vector3d>& positions,
                                  const Eigen::MatrixXd& errors, bool sizeToo);

/// Returns the relative change of size in stacked position errors, column by column.
Eigen::RowVectorXd sizeChange(const std::vector<Eigen::Vector3d>& positions,
                              const Eigen::MatrixXd& errors);

/// Returns the difference `to` minus `from` between the camera parameters in the given columns
/// (rotations, centers, intrinsics, offsets).
Eigen::VectorXd cameraDifference(const std::vector<CameraColumn>& columns, const BundleResult& from,
                                 const BundleResult& to);

} // namespace dewpoint::calibration
