// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace dewpoint::geometry {

/// Returns the mean of the vectors, or zero if there are none.
inline Eigen::Vector3d meanVector(const std::vector<Eigen::Vector3d>& vectors) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& vector : vectors) {
    sum += vector;
  }
  return sum / static_cast<double>(std::max<std::size_t>(vectors.size(), 1));
}

} // namespace dewpoint::geometry
