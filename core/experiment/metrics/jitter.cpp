// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/jitter.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace dewpoint::experiment {

double jitterOf(std::span<const ErrorSequence> sequences) {
  constexpr double kVarianceFactor = 6.0; // 1² + 2² + 1²
  double squares = 0.0;
  std::int64_t count = 0;
  for (const ErrorSequence& errors : sequences) {
    for (std::size_t k = 2; k < errors.size(); ++k) {
      if (!errors[k - 2] || !errors[k - 1] || !errors[k]) {
        continue;
      }
      const double square = (*errors[k - 2] - 2.0 * *errors[k - 1] + *errors[k]).squaredNorm();
      if (std::isfinite(square)) {
        squares += square;
        ++count;
      }
    }
  }
  return count > 0 ? std::sqrt(squares / (kVarianceFactor * static_cast<double>(count)))
                   : std::numeric_limits<double>::quiet_NaN();
}

} // namespace dewpoint::experiment
