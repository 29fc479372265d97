// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::geometry {

/// An upright box in the world frame, meters.
struct WorldBox {
  Eigen::Vector3d min = Eigen::Vector3d::Zero(); ///< its corner with the least coordinates
  Eigen::Vector3d max = Eigen::Vector3d::Zero(); ///< and that with the greatest

  Eigen::Vector3d center() const { return 0.5 * (min + max); }
  Eigen::Vector3d half() const { return 0.5 * (max - min); } ///< half sizes
  /// Whether a point lies in it, or within `margin` meters of it along each axis.
  bool contains(const Eigen::Vector3d& point, double margin = 0.0) const {
    return (point.array() >= min.array() - margin).all() &&
           (point.array() <= max.array() + margin).all();
  }

  bool operator==(const WorldBox&) const = default;
};

} // namespace dewpoint::geometry
