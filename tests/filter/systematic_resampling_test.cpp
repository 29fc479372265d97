// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/models.h"
#include "core/filter/systematic_resampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dewpoint::tests {
namespace {

static_assert(Resampler<SystematicResampling>);

/// How often each particle was picked in one draw.
Eigen::ArrayXi countsOf(const Eigen::ArrayXd& weights, Eigen::Index count, std::uint32_t trial) {
  Ancestors picked;
  SystematicResampling{}.drawAncestors(
      weights, count, RandomStream(17, trial, 0, RandomPurpose::Resampling), picked);
  EXPECT_EQ(picked.size(), static_cast<std::size_t>(count));
  EXPECT_TRUE(std::is_sorted(picked.begin(), picked.end()));
  Eigen::ArrayXi counts = Eigen::ArrayXi::Zero(weights.size());
  for (const std::int32_t ancestor : picked) {
    ++counts[ancestor];
  }
  return counts;
}

Eigen::ArrayXd uneven() {
  Eigen::ArrayXd weights(7);
  weights << 0.0, 0.31, 0.02, 0.0, 0.5, 0.17, 0.0;
  return weights;
}

TEST(SystematicResampling, EveryParticleFloorOrCeilOfItsShare) {
  const Eigen::ArrayXd weights = uneven();
  for (const Eigen::Index count : {1, 3, 10, 97}) {
    for (std::uint32_t trial = 0; trial < 200; ++trial) {
      const Eigen::ArrayXi counts = countsOf(weights, count, trial);
      for (Eigen::Index i = 0; i < weights.size(); ++i) {
        const double share = weights[i] * double(count);
        EXPECT_GE(counts[i], std::floor(share - 1e-9)) << i << " of " << count;
        EXPECT_LE(counts[i], std::ceil(share + 1e-9)) << i << " of " << count;
      }
    }
  }
}

// Expected picks count * weight. Of one draw the number is floor or ceil, so its standard
// deviation is at most 1/2; five standard errors of the mean of n draws.
TEST(SystematicResampling, IsUnbiased) {
  const Eigen::ArrayXd weights = uneven();
  constexpr int kTrials = 20000;
  constexpr Eigen::Index kCount = 9;
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(weights.size());
  for (std::uint32_t trial = 0; trial < kTrials; ++trial) {
    sum += countsOf(weights, kCount, trial).cast<double>();
  }
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    EXPECT_NEAR(sum[i] / kTrials, kCount * weights[i], 5.0 * 0.5 / std::sqrt(double(kTrials))) << i;
  }
}

TEST(SystematicResampling, NeverPicksAWeightOfZero) {
  Eigen::ArrayXd weights = Eigen::ArrayXd::Zero(1000);
  weights[500] = 1.0;
  EXPECT_EQ(countsOf(weights, 50, 0)[500], 50);
  // Tenths do not sum to 1 exactly; what rounding leaves must not reach the zeros behind.
  weights.setZero();
  weights.segment(3, 10).setConstant(0.1);
  for (std::uint32_t trial = 0; trial < 1000; ++trial) {
    const Eigen::ArrayXi counts = countsOf(weights, 1000, trial);
    EXPECT_EQ(counts.segment(3, 10).sum(), 1000);
  }
}

TEST(SystematicResampling, WeightsNeedNotSumToOne) {
  for (const double scale : {1e-200, 3.0, 1e200}) {
    EXPECT_TRUE((countsOf(scale * uneven(), 20, 5) == countsOf(uneven(), 20, 5)).all()) << scale;
  }
}

TEST(SystematicResampling, EqualWeightsKeepEveryParticle) {
  const Eigen::ArrayXd weights = Eigen::ArrayXd::Constant(64, 1.0 / 64.0);
  for (std::uint32_t trial = 0; trial < 100; ++trial) {
    EXPECT_TRUE((countsOf(weights, 64, trial) == 1).all());
  }
}

} // namespace
} // namespace dewpoint::tests
