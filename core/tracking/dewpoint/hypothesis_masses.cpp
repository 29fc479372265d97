// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/hypothesis_masses.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::tracking {

double shareOfLargest(std::span<const double> logMasses, double absence) {
  const auto top = std::max_element(logMasses.begin(), logMasses.end());
  double others = absence;
  for (auto mass = logMasses.begin(); mass != logMasses.end(); ++mass) {
    others += mass == top ? 0.0 : std::exp(*mass);
  }
  return 1.0 / (1.0 + others * std::exp(-*top));
}

} // namespace dewpoint::tracking
