// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/base/vector_kernel.h"
#include "core/filter/particle_set.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace dewpoint::filter {

/// Random walk of x, y and z that is equal in all directions (Barrera et al. 2005, equations 1 to
/// 3). Each step adds N(0, sigma²) noise to each of these coordinates. Other state coordinates do
/// not change.
struct IsotropicMotion {
  double sigma = 0.03; ///< standard deviation, meters per iteration; Barrera et al. 2005 use 0.03

  struct StepKernel {
    DEWPOINT_KERNEL void run(std::int64_t count, const double* __restrict step, double sigma,
                             double* __restrict coordinate) {
      for (std::int64_t i = 0; i < count; ++i) {
        coordinate[i] += sigma * step[i];
      }
    }
  };

  void predict(StateRows rows, std::uint32_t firstIndex, const RandomStream& stream) const {
    constexpr Eigen::Index kBlockSize = 256;
    std::array<std::array<double, kBlockSize>, 3> normal;
    for (Eigen::Index begin = 0; begin < rows.rows(); begin += kBlockSize) {
      const Eigen::Index count = std::min(kBlockSize, rows.rows() - begin);
      stream.fillNormal3(firstIndex + static_cast<std::uint32_t>(begin), count,
                         {normal[0].data(), normal[1].data(), normal[2].data()});
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const double* step = normal[static_cast<std::size_t>(axis)].data();
        runKernel<StepKernel>(std::int64_t{count}, step, sigma, rows.col(axis).data() + begin);
      }
    }
  }
};

} // namespace dewpoint::filter
