// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/multinomial_resampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::tests {
namespace {

TEST(MultinomialResampling, IsUnbiased) {
  Eigen::ArrayXd weights(5);
  weights << 0.5, 0.0, 0.2, 0.29, 0.01;
  constexpr int kDraws = 200000;
  Ancestors picked;
  MultinomialResampling{}.drawAncestors(weights, kDraws,
                                        RandomStream(11, 0, 0, RandomPurpose::Resampling), picked);
  ASSERT_EQ(picked.size(), static_cast<std::size_t>(kDraws));
  Eigen::ArrayXd counts = Eigen::ArrayXd::Zero(5);
  for (const Eigen::Index ancestor : picked) {
    counts[ancestor] += 1.0;
  }
  EXPECT_EQ(counts[1], 0.0);
  for (Eigen::Index i = 0; i < 5; ++i) {
    // Binomial: mean n w, standard deviation sqrt(n w (1 - w)); five of them.
    const double deviation = std::sqrt(kDraws * weights[i] * (1.0 - weights[i]));
    EXPECT_NEAR(counts[i], kDraws * weights[i], 5.0 * deviation);
  }
}

// Independent draws: the count of a particle of weight 1/2 among 10 has variance 10/4 = 2.5 (a
// systematic resampler would have almost none).
TEST(MultinomialResampling, DrawsAreIndependent) {
  const Eigen::ArrayXd weights = Eigen::ArrayXd::Constant(2, 0.5);
  constexpr int kTrials = 20000;
  double sum = 0.0;
  double squares = 0.0;
  Ancestors picked;
  for (std::uint32_t trial = 0; trial < kTrials; ++trial) {
    MultinomialResampling{}.drawAncestors(
        weights, 10, RandomStream(5, trial, 0, RandomPurpose::Resampling), picked);
    const auto ones = static_cast<double>(std::count(picked.begin(), picked.end(), 1));
    sum += ones;
    squares += ones * ones;
  }
  const double mean = sum / kTrials;
  EXPECT_NEAR(mean, 5.0, 5.0 * std::sqrt(2.5 / kTrials));
  // Standard error of a variance is near sqrt(2 / n) of it.
  EXPECT_NEAR(squares / kTrials - mean * mean, 2.5, 5.0 * 2.5 * std::sqrt(2.0 / kTrials));
}

TEST(MultinomialResampling, OneParticleWithAllTheWeightIsAlwaysPicked) {
  for (const Eigen::Index holder : {0, 3, 6}) {
    Eigen::ArrayXd weights = Eigen::ArrayXd::Zero(7);
    weights[holder] = 1e-300; // need not sum to 1
    Ancestors picked;
    MultinomialResampling{}.drawAncestors(weights, 1000,
                                          RandomStream(1, 0, 0, RandomPurpose::Resampling), picked);
    for (const Eigen::Index ancestor : picked) {
      ASSERT_EQ(ancestor, holder);
    }
  }
}

} // namespace
} // namespace dewpoint::tests
