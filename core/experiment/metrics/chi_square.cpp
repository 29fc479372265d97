// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/chi_square.h"

#include <cmath>
#include <limits>

namespace dewpoint::experiment {
namespace {

constexpr double kPrecision = std::numeric_limits<double>::epsilon();
constexpr int kMostTerms = 1000000;

/// x^a exp(-x) / Gamma(a), the factor both expansions share.
double leadingFactor(double a, double x) {
  return std::exp(a * std::log(x) - x - std::lgamma(a));
}

/// Lower incomplete gamma by its power series (DLMF 8.11.4), good for x < a + 1.
double lowerBySeries(double a, double x) {
  double term = 1.0 / a;
  double sum = term;
  for (int k = 1; k < kMostTerms && term > sum * kPrecision; ++k) {
    term *= x / (a + k);
    sum += term;
  }
  return sum * leadingFactor(a, x);
}

/// Upper incomplete gamma by the even part of its continued fraction (DLMF 8.9.2), evaluated from
/// the front (Lentz), good for x >= a + 1.
double upperByFraction(double a, double x) {
  double denominator = x + 1.0 - a;
  double numeratorRatio = std::numeric_limits<double>::infinity();
  double denominatorRatio = 1.0 / denominator;
  double value = denominatorRatio;
  for (int k = 1; k < kMostTerms; ++k) {
    const double coefficient = -k * (k - a);
    denominator += 2.0;
    denominatorRatio = 1.0 / (coefficient * denominatorRatio + denominator);
    numeratorRatio = denominator + coefficient / numeratorRatio;
    const double factor = numeratorRatio * denominatorRatio;
    value *= factor;
    if (std::abs(factor - 1.0) <= kPrecision)
      break;
  }
  return value * leadingFactor(a, x);
}

} // namespace

double chiSquareProbability(double value, double degrees) {
  if (value <= 0.0)
    return 0.0;
  const double a = degrees / 2.0;
  const double x = value / 2.0;
  return x < a + 1.0 ? lowerBySeries(a, x) : 1.0 - upperByFraction(a, x);
}

double chiSquareQuantile(double probability, double degrees) {
  double low = 0.0;
  double high = degrees + 1.0;
  while (chiSquareProbability(high, degrees) < probability)
    high *= 2.0;
  while (high - low > 1e-13 * high) {
    const double middle = 0.5 * (low + high);
    (chiSquareProbability(middle, degrees) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

} // namespace dewpoint::experiment
