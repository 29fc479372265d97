// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace dewpoint {

/// Resampling of CONDENSATION (Isard & Blake 1998): for each new particle an independent uniform
/// draw, looked up in the cumulative weights by binary search. Unbiased; a particle of weight zero
/// is never picked. The weights need not sum to 1, but at least one must be positive.
struct MultinomialResampling {
  void ancestors(const Eigen::ArrayXd& weights, Eigen::Index count, const RandomStream& stream,
                 std::vector<Eigen::Index>& picked) const {
    std::vector<double> cumulative(static_cast<std::size_t>(weights.size()));
    double total = 0.0;
    for (std::size_t i = 0; i < cumulative.size(); ++i) {
      total += weights[static_cast<Eigen::Index>(i)];
      cumulative[i] = total;
    }
    // Where rounding would carry a draw past the end, the last particle of positive weight is
    // meant.
    const auto last = std::lower_bound(cumulative.begin(), cumulative.end(), total);
    picked.resize(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < picked.size(); ++i) {
      const double draw = stream.uniform(static_cast<std::uint32_t>(i)) * total;
      picked[i] = std::upper_bound(cumulative.begin(), last, draw) - cumulative.begin();
    }
  }
};

} // namespace dewpoint
