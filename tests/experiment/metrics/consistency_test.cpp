// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/experiment/metrics/chi_square.h"
#include "core/experiment/metrics/consistency.h"
#include "tests/base/not_a_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace dewpoint::tests {
namespace {

// Values of printed chi-square tables, and two forms in closed terms: P(x, 2) = 1 - exp(-x / 2),
// P(x, 1) = erf(sqrt(x / 2)).
TEST(ChiSquare, TablesAndClosedForms) {
  EXPECT_NEAR(chiSquareQuantile(0.95, 1.0), 3.841459, 5e-7);
  EXPECT_NEAR(chiSquareQuantile(0.95, 3.0), 7.814728, 5e-7);
  EXPECT_NEAR(chiSquareQuantile(0.95, 3.0), kChiSquared95ThreeDof, 1e-11);
  EXPECT_NEAR(chiSquareQuantile(0.50, 3.0), 2.365974, 5e-7);
  EXPECT_NEAR(chiSquareQuantile(0.50, 3.0), kChiSquared50ThreeDof, 1e-11);
  EXPECT_NEAR(chiSquareQuantile(0.025, 30.0), 16.791, 5e-4);
  EXPECT_NEAR(chiSquareQuantile(0.975, 30.0), 46.979, 5e-4);
  EXPECT_NEAR(chiSquareQuantile(0.025, 100.0), 74.222, 5e-4);
  EXPECT_NEAR(chiSquareQuantile(0.975, 100.0), 129.561, 5e-4);
  for (const double x : {0.01, 0.5, 2.0, 9.0, 40.0}) {
    EXPECT_NEAR(chiSquareProbability(x, 2.0), 1.0 - std::exp(-x / 2.0), 1e-14);
    EXPECT_NEAR(chiSquareProbability(x, 1.0), std::erf(std::sqrt(x / 2.0)), 1e-14);
  }
  EXPECT_EQ(chiSquareProbability(0.0, 3.0), 0.0);
  EXPECT_EQ(chiSquareProbability(-1.0, 3.0), 0.0);
}

// For many degrees k the variable is nearly normal, mean k and variance 2 k, with the correction of
// Cornish & Fisher: quantile = k + z sqrt(2 k) + 2/3 (z² - 1) + O(1 / sqrt(k)).
TEST(ChiSquare, ManyDegreesAreNearlyNormal) {
  const double z = 1.959963985;
  const double degrees = 300000.0;
  const double expected = degrees + z * std::sqrt(2.0 * degrees) + 2.0 / 3.0 * (z * z - 1.0);
  EXPECT_NEAR(chiSquareQuantile(0.975, degrees), expected, 0.01);
}

StateError sampleOf(const Eigen::Vector3d& error, const Eigen::Vector3d& variances) {
  return {error, variances.asDiagonal()};
}

// Variances 1, 4, 9. Error (1, 2, 3): 1 + 4/4 + 9/9 = 3. Error (3, 0, 0): 9, outside 7.81.
// Mean 6; per axis (1 + 9) / 2 = 5, 1/2, 1/2. Bounds of two samples: chi-square with 6 degrees,
// 1.237 and 14.449 in the tables, halved; per axis with 2 degrees, -2 ln(0.975) / 2 and
// -2 ln(0.025) / 2.
TEST(Consistency, HandWorked) {
  const Eigen::Vector3d variances(1.0, 4.0, 9.0);
  const std::vector<StateError> errors{sampleOf({1.0, 2.0, 3.0}, variances),
                                       sampleOf({3.0, 0.0, 0.0}, variances)};
  const Consistency result = computeConsistency(errors);
  EXPECT_DOUBLE_EQ(result.nees.value, 6.0);
  EXPECT_NEAR(result.nees.low, 1.237 / 2.0, 5e-4);
  EXPECT_NEAR(result.nees.high, 14.449 / 2.0, 5e-4);
  EXPECT_DOUBLE_EQ(result.axisNees[0], 5.0);
  EXPECT_DOUBLE_EQ(result.axisNees[1], 0.5);
  EXPECT_DOUBLE_EQ(result.axisNees[2], 0.5);
  EXPECT_NEAR(result.axisNeesBounds.low, -std::log(0.975), 1e-11);
  EXPECT_NEAR(result.axisNeesBounds.high, -std::log(0.025), 1e-11);
  EXPECT_EQ(result.coverage95.count, 1);
  EXPECT_EQ(result.coverage95.total, 2);
}

// Covariance [[2, 1], [1, 2]] in x and y has the inverse [[2, -1], [-1, 2]] / 3: error (1, 1, 0)
// gives (2 - 1 - 1 + 2) / 3 = 2/3, error (1, -1, 0) gives (2 + 1 + 1 + 2) / 3 = 2.
TEST(Consistency, CorrelatedAxes) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  covariance.topLeftCorner<2, 2>() << 2.0, 1.0, 1.0, 2.0;
  EXPECT_NEAR(normalizedErrorSquared({{1.0, 1.0, 0.0}, covariance}), 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(normalizedErrorSquared({{1.0, -1.0, 0.0}, covariance}), 2.0, 1e-15);
}

// Unit variances: squared errors 2.25 (inside both), 4 (between 2.366 and 7.815) and 9 (outside
// both).
TEST(Consistency, CountsBothEllipsoids) {
  const Eigen::Vector3d unit(1.0, 1.0, 1.0);
  const std::vector<StateError> errors{sampleOf({1.5, 0.0, 0.0}, unit),
                                       sampleOf({0.0, 2.0, 0.0}, unit),
                                       sampleOf({0.0, 0.0, 3.0}, unit)};
  const Consistency result = computeConsistency(errors);
  EXPECT_EQ(result.coverage50.count, 1);
  EXPECT_EQ(result.coverage50.total, 3);
  EXPECT_EQ(result.coverage95.count, 2);
  EXPECT_EQ(result.coverage95.total, 3);
}

TEST(Consistency, UnusableSamplesCountAsOutside) {
  const Eigen::Vector3d error(0.1, 0.0, 0.0);
  const std::vector<StateError> errors{
      sampleOf(error, {1.0, 1.0, 1.0}), sampleOf(error, {0.0, 0.0, 0.0}),
      sampleOf(error, {1.0, -1.0, 1.0}), sampleOf({kNotANumber, 0.0, 0.0}, {1.0, 1.0, 1.0})};
  const Consistency result = computeConsistency(errors);
  EXPECT_EQ(result.unusableSampleCount, 3);
  EXPECT_NEAR(result.nees.value, 0.01, 1e-15);
  EXPECT_EQ(result.coverage95.count, 1);
  EXPECT_EQ(result.coverage95.total, 4);
  EXPECT_EQ(result.coverage50.count, 1);
  EXPECT_EQ(result.coverage50.total, 4);
  const Consistency none = computeConsistency({});
  EXPECT_TRUE(std::isnan(none.nees.value));
  EXPECT_TRUE(std::isnan(none.coverage95.value()));
  EXPECT_TRUE(std::isnan(none.coverage50.value()));
}

// Errors drawn from the stated covariance, 4,000 of them, seed 3: consistent at the 99.9 % level,
// and the share inside within four standard deviations, 4 sqrt(0.95 * 0.05 / 4000) = 0.014.
TEST(Consistency, TrueCovariancesPass) {
  const RandomStream random(3, 0, 0, RandomPurpose::Noise);
  const Eigen::Vector3d variances(1e-6, 4e-6, 25e-6);
  std::vector<StateError> errors;
  for (std::uint32_t k = 0; k < 4000; ++k) {
    const auto normal = random.normal4(k);
    errors.push_back(sampleOf({1e-3 * normal[0], 2e-3 * normal[1], 5e-3 * normal[2]}, variances));
  }
  const Consistency result = computeConsistency(errors, 0.999);
  EXPECT_GT(result.nees.value, result.nees.low);
  EXPECT_LT(result.nees.value, result.nees.high);
  EXPECT_GT(result.axisNees.minCoeff(), result.axisNeesBounds.low);
  EXPECT_LT(result.axisNees.maxCoeff(), result.axisNeesBounds.high);
  EXPECT_NEAR(result.coverage95.value(), 0.95, 0.014);
  EXPECT_NEAR(result.coverage50.value(), 0.5, 0.032) << "4 sqrt(0.5 * 0.5 / 4000)";
}

} // namespace
} // namespace dewpoint::tests
