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
  void ancestors(const Eigen::ArrayXd& weights, Eigen::Index count, const RandomStream& stream,
                 Ancestors& picked) const {
    picked.resize(static_cast<std::size_t>(count));
    Eigen::Index last = 0; // of positive weight, in case rounding carries a step past the end
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
      last = weights[i] > 0.0 ? i : last;
    }
    const double step = weights.sum() / static_cast<double>(count);
    const double first = stream.uniform(0) * step;
    double cumulative = weights[0];
    Eigen::Index ancestor = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
      const double draw = first + static_cast<double>(i) * step;
      while (draw >= cumulative && ancestor < last) {
        cumulative += weights[++ancestor];
      }
      picked[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(ancestor);
    }
  }
};

} // namespace dewpoint::filter
