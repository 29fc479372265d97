// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/proportion.h"

#include "core/experiment/metrics/chi_square.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::experiment {

double Proportion::value() const {
  return total == 0 ? std::numeric_limits<double>::quiet_NaN()
                    : static_cast<double>(count) / static_cast<double>(total);
}

Interval wilsonInterval(const Proportion& proportion, double level) {
  const double share = proportion.value();
  if (proportion.total == 0)
    return {share, 0.0, 1.0};
  const auto trials = static_cast<double>(proportion.total);
  // The square of a normal variable is chi-square with one degree of freedom.
  const double squaredNormal = chiSquareQuantile(level, 1.0);
  const double scale = 1.0 + squaredNormal / trials;
  const double center = (share + squaredNormal / (2.0 * trials)) / scale;
  const double half = std::sqrt(squaredNormal * (share * (1.0 - share) / trials +
                                                 squaredNormal / (4.0 * trials * trials))) /
                      scale;
  return {share, std::max(0.0, center - half), std::min(1.0, center + half)};
}

} // namespace dewpoint::experiment
