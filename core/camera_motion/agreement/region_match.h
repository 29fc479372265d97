// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::camera_motion {

/// A region in a target's color in one image, as rays of the camera. All members but `counts` are
/// in terms of the rays; `radius`, `sigma` and `bias` are angles in radians.
struct SeenRegion {
  Eigen::Vector3d direction; ///< to its center: unit vector, camera axes
  Eigen::Vector3d rate;      ///< change of `direction` per second
  double radius;
  double sigma; ///< standard deviation of the center, per axis
  double bias;  ///< part of `sigma` that stays the same while the object moves
  bool counts;  ///< whether it counts as evidence (RegionSighting)
};

/// How well a region of one camera and a region of another one match as the same object.
struct RegionMatch {
  double density = 0.0;  ///< likelihood relative to that of unrelated regions
  double residual = 0.0; ///< distance at which the rays pass each other, in standard deviations
  Eigen::Vector3d byU =
      Eigen::Vector3d::Zero(); ///< derivatives of `residual` by the directions `u` and `v`
  Eigen::Vector3d byV = Eigen::Vector3d::Zero();
  double size = 0.0; ///< radius of the object that both see, in the unit of `apart`; 0: not known
};

/// Compares region `a`, seen along the unit vector `u` of the world, with region `b`, seen along
/// `v` by a camera displaced by `apart` from the first one (not zero). The image of the second
/// camera is `field` radians high. `widening`: additional uncertainty of the directions, radians.
RegionMatch matchRegions(const SeenRegion& a, const Eigen::Vector3d& u, const SeenRegion& b,
                         const Eigen::Vector3d& v, const Eigen::Vector3d& apart, double widening,
                         double field);

} // namespace dewpoint::camera_motion
