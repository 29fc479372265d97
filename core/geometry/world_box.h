// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::geometry {

/// Axis-aligned box in the world frame, meters.
struct WorldBox {
  Eigen::Vector3d min = Eigen::Vector3d::Zero(); ///< corner with the smallest coordinates
  Eigen::Vector3d max = Eigen::Vector3d::Zero(); ///< corner with the largest coordinates

  Eigen::Vector3d center() const { return 0.5 * (min + max); }
  /// Returns half of the size along each axis, meters.
  Eigen::Vector3d halfSize() const { return 0.5 * (max - min); }
  /// Returns whether a point lies in the box, or within `margin` meters of it along each axis.
  bool contains(const Eigen::Vector3d& point, double margin = 0.0) const {
    return (point.array() >= min.array() - margin).all() &&
           (point.array() <= max.array() + margin).all();
  }

  bool operator==(const WorldBox&) const = default;
};

} // namespace dewpoint::geometry
