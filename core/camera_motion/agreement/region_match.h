// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::camera_motion {

/// A region of a target's color in one image, as a camera sees it: all but `counts` are angles of
/// its rays, radians.
struct SeenRegion {
  Eigen::Vector3d direction; ///< of its center: unit, camera axes
  Eigen::Vector3d rate;      ///< of `direction`, per second
  double radius;
  double sigma; ///< of the center, per axis
  double bias;  ///< the part of it that stays while the object moves
  bool counts;  ///< as evidence (RegionSighting)
};

/// How a region of one camera fits one of another as the same object.
struct RegionMatch {
  double density = 0.0;  ///< likelihood, relative to that of unrelated regions
  double residual = 0.0; ///< how far the rays pass each other, standard deviations
  Eigen::Vector3d byU = Eigen::Vector3d::Zero(); ///< derivatives of `residual`
  Eigen::Vector3d byV = Eigen::Vector3d::Zero();
  double size = 0.0; ///< radius of what both see, in the unit of `apart`; 0: not known
};

/// Compares region `a`, seen along the unit vector `u` of the world, with region `b`, seen along
/// `v` by a camera that stands `apart` from the first one (not zero) and whose image is `field`
/// radians high. `widening`: radians that directions are less certain than stated.
RegionMatch matchRegions(const SeenRegion& a, const Eigen::Vector3d& u, const SeenRegion& b,
                         const Eigen::Vector3d& v, const Eigen::Vector3d& apart, double widening,
                         double field);

} // namespace dewpoint::camera_motion
