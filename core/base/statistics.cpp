// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dewpoint::base {

double upperMedianInPlace(std::span<double> values) {
  if (values.empty()) {
    return 0.0;
  }
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double upperMedian(std::vector<double> values) {
  return upperMedianInPlace(values);
}

double median(std::vector<double> values) {
  if (values.empty()) {
    return 0.0;
  }
  std::sort(values.begin(), values.end());
  const auto middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double quantile(const std::vector<double>& sorted, double fraction) {
  const double place = fraction * static_cast<double>(sorted.size() - 1);
  const auto low = static_cast<std::size_t>(place);
  const std::size_t high = std::min(low + 1, sorted.size() - 1);
  return sorted[low] + (place - static_cast<double>(low)) * (sorted[high] - sorted[low]);
}

double studentQuantile95(double freedoms) {
  constexpr double kNormal = 1.959964; // of the normal distribution
  const double first = (std::pow(kNormal, 3) + kNormal) / 4.0;
  const double second =
      (5.0 * std::pow(kNormal, 5) + 16.0 * std::pow(kNormal, 3) + 3.0 * kNormal) / 96.0;
  const double third = (3.0 * std::pow(kNormal, 7) + 19.0 * std::pow(kNormal, 5) +
                        17.0 * std::pow(kNormal, 3) - 15.0 * kNormal) /
                       384.0;
  return kNormal + first / freedoms + second / std::pow(freedoms, 2) +
         third / std::pow(freedoms, 3);
}

} // namespace dewpoint::base
