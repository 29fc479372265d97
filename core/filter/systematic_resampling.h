// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/filter/particle_set.h"

#include <Eigen/Core>

#include <cstdint>

namespace dewpoint::filter {

/// Systematic resampling (Kitagawa 1996; Arulampalam et al. 2002, algorithm 2): one uniform draw,
/// followed by equal steps through the cumulative weights. The method is unbiased. The number of
/// times that a particle is picked is its expected number, rounded up or down. The weights need not
/// sum to 1, but at least one must be positive.
struct SystematicResampling {
  void drawAncestors(const Eigen::ArrayXd& weights, Eigen::Index count, const RandomStream& stream,
                     Ancestors& picked) const {
    picked.resize(static_cast<std::size_t>(count));
    // Last positive weight, in case rounding carries a step past the end.
    Eigen::Index lastPositive = 0;
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
      lastPositive = weights[i] > 0.0 ? i : lastPositive;
    }
    const double step = weights.sum() / static_cast<double>(count);
    const double first = stream.uniform(0) * step;
    double cumulativeWeight = weights[0];
    Eigen::Index ancestor = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
      const double draw = first + static_cast<double>(i) * step;
      while (draw >= cumulativeWeight && ancestor < lastPositive) {
        cumulativeWeight += weights[++ancestor];
      }
      picked[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(ancestor);
    }
  }
};

} // namespace dewpoint::filter
