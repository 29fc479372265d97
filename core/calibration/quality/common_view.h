// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace dewpoint::calibration {

/// Region that at least two cameras see, represented by positions on a lattice.
struct CommonView {
  std::vector<Eigen::Vector3d> positions; ///< positions in the world frame, meters
  std::vector<std::vector<std::size_t>>
      camerasPerPosition; ///< indices of the cameras that see each position
};

/// Returns positions that at least two cameras see. They are chosen from a lattice of 16 x 16 x 16
/// positions, which fills the box around the views of all cameras. The view of a camera is assumed
/// to end at 1.25 times the distance within which it sees 95 % of its `targets`. A camera that sees
/// no target is left out. Empty if fewer than two cameras see targets.
CommonView findCommonView(const CameraRig& rig, const std::vector<Eigen::Vector3d>& targets);

/// Box whose sides are parallel to the principal axes of some positions.
struct PrincipalBox {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< mean of the positions, world, meters
  /// The columns are the axes. The axis along which the positions vary most is the first.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d low = Eigen::Vector3d::Zero();  ///< lower bounds, from `center` along the axes, m
  Eigen::Vector3d high = Eigen::Vector3d::Zero(); ///< upper bounds, from `center` along the axes, m

  Eigen::Vector3d extents() const { return high - low; }
  /// Returns the distance of a position from the box, meters; 0 inside.
  double distanceTo(const Eigen::Vector3d& position) const;
};

/// Returns the box around the positions. Along each axis, the fraction `outliers` of the positions
/// (at least 0, less than 0.5) lies beyond the box at each end. The center and the bounds are 0 if
/// there are no positions.
PrincipalBox principalBox(const std::vector<Eigen::Vector3d>& positions, double outliers);

} // namespace dewpoint::calibration
