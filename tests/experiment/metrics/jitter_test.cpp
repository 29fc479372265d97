// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/jitter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace dewpoint::tests {
namespace {

ErrorSequence alongX(const std::vector<double>& errors) {
  ErrorSequence sequence;
  for (const double error : errors) {
    sequence.emplace_back(Eigen::Vector3d(error, 0.0, 0.0));
  }
  return sequence;
}

double jitterOfOne(const ErrorSequence& sequence) {
  return jitterOf({&sequence, 1});
}

// Second differences of 0 1 0 1: -2 and 2; sqrt(4 / 6).
TEST(Jitter, HandWorked) {
  EXPECT_DOUBLE_EQ(jitterOfOne(alongX({0.0, 1.0, 0.0, 1.0})), std::sqrt(4.0 / 6.0));
}

TEST(Jitter, OfBiasAndEvenDriftIsNone) {
  EXPECT_EQ(jitterOfOne(alongX({5.0, 5.0, 5.0, 5.0})), 0.0);
  EXPECT_EQ(jitterOfOne(alongX({1.0, 2.0, 3.0, 4.0})), 0.0);
}

TEST(Jitter, OfIndependentNoiseIsItsSize) {
  // Standard deviations of 1, 2 and 2 mm around a bias: sqrt(1 + 4 + 4) = 3 mm. With 20,000 frames
  // the mean of the squares is known to about 1 %.
  std::mt19937 random(1); // NOLINT(cert-msc32-c,cert-msc51-cpp) the same in every run
  std::normal_distribution<double> normal;
  ErrorSequence sequence;
  for (int k = 0; k < 20000; ++k) {
    const double x = normal(random);
    const double y = normal(random);
    const double z = normal(random);
    sequence.emplace_back(Eigen::Vector3d(0.01 + 0.001 * x, 0.002 * y, 0.002 * z));
  }
  EXPECT_NEAR(jitterOfOne(sequence), 0.003, 0.00006);
}

TEST(Jitter, DoesNotReachAcrossGapsOrTargets) {
  ErrorSequence gap = alongX({0.0, 1.0, 0.0, 1.0, 1.0, 1.0});
  gap[2].reset();
  EXPECT_EQ(jitterOfOne(gap), 0.0) << "only the last three are successive";
  const std::vector<ErrorSequence> two{alongX({0.0, 0.0}), alongX({1.0, 1.0, 1.0})};
  EXPECT_EQ(jitterOf(two), 0.0);
}

TEST(Jitter, OfNothingIsNothing) {
  EXPECT_TRUE(std::isnan(jitterOf({})));
  EXPECT_TRUE(std::isnan(jitterOfOne(alongX({1.0, 2.0}))));
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(jitterOfOne(alongX({1.0, nothing, 2.0}))));
}

} // namespace
} // namespace dewpoint::tests
