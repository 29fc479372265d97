// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/filter/particle_set.h"

#include <cstddef>
#include <cstdint>

namespace dewpoint {

/// Random walk of x, y and z, no direction privileged (Barrera et al. 2005, equations 1 to 3):
/// each coordinate += N(0, sigma). Further state coordinates stay as they are.
struct IsotropicMotion {
  double sigma = 0.03; ///< metres per iteration

  void predict(StateRows rows, std::uint32_t firstIndex, const RandomStream& stream) const {
    for (Eigen::Index row = 0; row < rows.rows(); ++row) {
      const auto normal = stream.normal4(firstIndex + static_cast<std::uint32_t>(row));
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        rows(row, axis) += sigma * normal[static_cast<std::size_t>(axis)];
      }
    }
  }
};

} // namespace dewpoint
