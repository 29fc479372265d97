// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace dewpoint::tests {
namespace {

using Words = std::array<std::uint32_t, 4>;

// Known answers of Philox4x32-10: the file kat_vectors of Random123, by the authors of the paper.
TEST(Philox, KnownAnswers) {
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(RandomStream, EveryPartOfTheKeyMatters) {
  const Words reference = RandomStream(1, 2, 3, RandomPurpose::Motion).randomWords(4, 5);
  EXPECT_EQ(reference, RandomStream(1, 2, 3, RandomPurpose::Motion).randomWords(4, 5));
  const std::set<Words> all{
      reference,
      RandomStream(0, 2, 3, RandomPurpose::Motion).randomWords(4, 5),
      RandomStream(1 + (1ULL << 32U), 2, 3, RandomPurpose::Motion).randomWords(4, 5),
      RandomStream(1, 3, 3, RandomPurpose::Motion).randomWords(4, 5),
      RandomStream(1, 2, 2, RandomPurpose::Motion).randomWords(4, 5),
      RandomStream(1, 2, 3, RandomPurpose::Resampling).randomWords(4, 5),
      RandomStream(1, 2, 3, RandomPurpose::Motion).randomWords(5, 5),
      RandomStream(1, 2, 3, RandomPurpose::Motion).randomWords(4, 4),
  };
  EXPECT_EQ(all.size(), 8U);
}

TEST(RandomStream, UniformStaysInItsIntervalWithItsMoments) {
  const RandomStream stream(7, 0, 0, RandomPurpose::Noise);
  constexpr int kCount = 100000;
  double sum = 0.0;
  double squares = 0.0;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const double value = stream.uniform(i);
    ASSERT_GE(value, 0.0);
    ASSERT_LT(value, 1.0);
    for (const double part : stream.uniform3(i)) {
      ASSERT_GE(part, 0.0);
      ASSERT_LT(part, 1.0);
    }
    sum += value;
    squares += value * value;
  }
  // Mean 1/2, second moment 1/3; standard errors sqrt(1/12/n) = 0.0009 and sqrt(4/45/n) = 0.0009.
  EXPECT_NEAR(sum / kCount, 0.5, 5 * 0.0009);
  EXPECT_NEAR(squares / kCount, 1.0 / 3.0, 5 * 0.0009);
}

TEST(RandomStream, NormalsHaveTheirMomentsAndAreIndependent) {
  const RandomStream stream(42, 3, 1, RandomPurpose::Motion);
  constexpr int kCount = 100000;
  std::array<double, 4> sum{};
  std::array<double, 4> fourth{};
  std::array<std::array<double, 4>, 4> products{};
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const auto normal = stream.normal4(i);
    for (std::size_t a = 0; a < 4; ++a) {
      ASSERT_TRUE(std::isfinite(normal[a]));
      sum[a] += normal[a];
      fourth[a] += std::pow(normal[a], 4);
      for (std::size_t b = 0; b < 4; ++b) {
        products[a][b] += normal[a] * normal[b];
      }
    }
  }
  // Standard errors for n = 100000: mean 1/sqrt(n), variance sqrt(2/n), product 1/sqrt(n), fourth
  // moment (3 for a normal) sqrt(96/n). Five of them.
  const double unit = 5.0 / std::sqrt(static_cast<double>(kCount));
  for (std::size_t a = 0; a < 4; ++a) {
    EXPECT_NEAR(sum[a] / kCount, 0.0, unit);
    EXPECT_NEAR(fourth[a] / kCount, 3.0, unit * std::sqrt(96.0));
    for (std::size_t b = 0; b < 4; ++b) {
      EXPECT_NEAR(products[a][b] / kCount, a == b ? 1.0 : 0.0, unit * std::sqrt(2.0));
    }
  }
}

TEST(RandomStream, ExponentialsHaveTheirMoments) {
  const RandomStream stream(6, 0, 1, RandomPurpose::Noise);
  constexpr int kCount = 100000;
  std::array<double, 4> sum{};
  std::array<std::array<double, 4>, 4> products{};
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const auto value = stream.exponential4(i);
    for (std::size_t a = 0; a < 4; ++a) {
      ASSERT_GE(value[a], 0.0F);
      ASSERT_FALSE(std::signbit(value[a]));
      sum[a] += double{value[a]};
      for (std::size_t b = 0; b < 4; ++b) {
        products[a][b] += (double{value[a]} - 1.0) * (double{value[b]} - 1.0);
      }
    }
  }
  // Mean 1, variance 1, fourth central moment 9: standard errors 1/sqrt(n) and sqrt(8/n); five.
  const double unit = 5.0 / std::sqrt(double(kCount));
  for (std::size_t a = 0; a < 4; ++a) {
    EXPECT_NEAR(sum[a] / kCount, 1.0, unit);
    for (std::size_t b = 0; b < 4; ++b) {
      EXPECT_NEAR(products[a][b] / kCount, a == b ? 1.0 : 0.0, unit * std::sqrt(8.0));
    }
  }
}

TEST(DerivedSeed, PartZeroKeepsTheSeedAndOthersDiffer) {
  EXPECT_EQ(derivedSeed(99, 0), 99U);
  const std::set<std::uint64_t> seeds{derivedSeed(99, 0), derivedSeed(99, 1), derivedSeed(99, 2),
                                      derivedSeed(98, 1)};
  EXPECT_EQ(seeds.size(), 4U);
}

} // namespace
} // namespace dewpoint::tests
