// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::calibration {

/// How errors of cameras become errors of positions that are triangulated with them, by first
/// order.
struct PositionErrors {
  std::vector<Eigen::Vector3d> positions; ///< meters
  Eigen::MatrixXd fromCameras;            ///< 3 times positions x columns of the covariance
  std::vector<Eigen::Matrix3d> noise;     ///< of one measurement, for a pixel's sigma of 1
};

/// At up to `most` positions spread over those of the result; positions that fewer than two cameras
/// see are left out. Time offsets do not count: the target is at rest.
PositionErrors propagateToPositions(const BundleProblem& problem, const BundleResult& result,
                                    std::size_t most);

/// Takes the common rigid motion (and size) out of stacked errors of positions, column by column.
Eigen::MatrixXd removeRigidMotion(const std::vector<Eigen::Vector3d>& positions,
                                  const Eigen::MatrixXd& errors, bool sizeToo);

/// The relative change of size in stacked errors of positions, column by column.
Eigen::RowVectorXd sizeChange(const std::vector<Eigen::Vector3d>& positions,
                              const Eigen::MatrixXd& errors);

/// What `to` differs from `from` in, in the given columns (turns, centers, lens, offsets).
Eigen::VectorXd cameraDifference(const std::vector<CameraColumn>& columns, const BundleResult& from,
                                 const BundleResult& to);

} // namespace dewpoint::calibration
