// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/consistency.h"

#include "core/experiment/metrics/chi_square.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <limits>

namespace dewpoint::experiment {
namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The mean of `samples` chi-square variables of `degrees` each is, times their number, chi-square
/// with samples * degrees.
Interval meanBounds(double mean, double samples, double degrees, double level) {
  if (samples == 0.0)
    return {mean, 0.0, kInfinity};
  const double low = chiSquareQuantile((1.0 - level) / 2.0, samples * degrees) / samples;
  const double high = chiSquareQuantile((1.0 + level) / 2.0, samples * degrees) / samples;
  return {mean, low, high};
}

} // namespace

double normalizedErrorSquared(const StateError& sample) {
  if (!sample.error.allFinite() || !sample.covariance.allFinite())
    return kUndefined;
  const Eigen::LLT<Eigen::Matrix3d> factor(sample.covariance);
  if (factor.info() != Eigen::Success)
    return kUndefined;
  const double value = sample.error.dot(factor.solve(sample.error));
  return std::isfinite(value) ? value : kUndefined;
}

Consistency computeConsistency(std::span<const StateError> errors, double level) {
  Consistency result;
  result.sampleCount = static_cast<std::int64_t>(errors.size());
  result.coverage95.total = result.sampleCount;
  result.coverage50.total = result.sampleCount;
  double sum = 0.0;
  for (const StateError& sample : errors) {
    const double value = normalizedErrorSquared(sample);
    if (std::isnan(value)) {
      ++result.unusableSampleCount;
      continue;
    }
    sum += value;
    result.axisNees +=
        (sample.error.array().square() / sample.covariance.diagonal().array()).matrix();
    if (value <= kChiSquared95ThreeDof)
      ++result.coverage95.count;
    if (value <= kChiSquared50ThreeDof)
      ++result.coverage50.count;
  }
  const auto usable = static_cast<double>(result.sampleCount - result.unusableSampleCount);
  const bool any = usable > 0.0;
  result.nees = meanBounds(any ? sum / usable : kUndefined, usable, 3.0, level);
  result.axisNees = any ? (result.axisNees / usable).eval() : Eigen::Vector3d::Constant(kUndefined);
  result.axisNeesBounds = meanBounds(1.0, usable, 1.0, level);
  return result;
}

} // namespace dewpoint::experiment
