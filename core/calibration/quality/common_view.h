// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace dewpoint::calibration {

/// Region that several cameras see together, as positions on a lattice.
struct CommonView {
  std::vector<Eigen::Vector3d> positions;        ///< seen by at least two cameras; world, meters
  std::vector<std::vector<std::size_t>> cameras; ///< indices of the cameras that see each position
};

/// Returns the positions that at least two cameras see, on a lattice of 16 x 16 x 16 positions over
/// the box that contains the view of each camera. The view of a camera ends at 1.25 times the
/// distance below which 95 % of those `targets` are that the camera sees. A camera that sees no
/// target is left out. Empty if fewer than two cameras see targets.
CommonView commonView(const CameraRig& rig, const std::vector<Eigen::Vector3d>& targets);

/// Box along the principal axes of positions.
struct PrincipalBox {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< columns, the longest extent first
  Eigen::Vector3d low = Eigen::Vector3d::Zero();      ///< lower bounds along the axes, meters
  Eigen::Vector3d high = Eigen::Vector3d::Zero();     ///< upper bounds along the axes, meters

  Eigen::Vector3d extents() const { return high - low; }
  /// Returns the distance of a position from the box, meters; 0 inside.
  double distance(const Eigen::Vector3d& position) const;
};

/// Returns the box that contains the positions, without the fraction `outliers` (0 to below 0.5) of
/// them at each end of each axis. All zero if there are no positions.
PrincipalBox principalBox(const std::vector<Eigen::Vector3d>& positions, double outliers);

} // namespace dewpoint::calibration
