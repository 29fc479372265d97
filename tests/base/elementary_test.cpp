// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/elementary.h"
#include "core/base/elementary_single.h"
#include "core/base/instruction_set.h"
#include "core/base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace dewpoint::tests {
namespace {

// The standard library is right to half a unit in the last place, 1.1e-16; ours to a few of them.
TEST(Elementary, LogarithmIsThatOfTheLibrary) {
  for (double x = 1e-10; x < 1e10; x *= 1.0037) {
    EXPECT_NEAR(logarithm(x), std::log(x), 1e-15 * std::max(1.0, std::abs(std::log(x)))) << x;
  }
  for (double step = 1e-10; step < 0.4; step *= 1.1) { // near 1 the relative error counts
    EXPECT_NEAR(logarithm(1.0 - step) / std::log1p(-(1.0 - (1.0 - step))), 1.0, 1e-15) << step;
  }
  EXPECT_EQ(logarithm(1.0), 0.0);
}

TEST(Elementary, CosineAndSineAreThoseOfTheLibrary) {
  for (std::uint64_t turn = 0; turn < (std::uint64_t{1} << 32U); turn += 999983) {
    const auto [cosine, sine] = cosineSine(static_cast<std::uint32_t>(turn));
    const double angle = double(turn) * (0x1.0p-31 * std::numbers::pi);
    EXPECT_NEAR(cosine, std::cos(angle), 1e-15) << turn; // the angle itself is rounded at 1e-15
    EXPECT_NEAR(sine, std::sin(angle), 1e-15) << turn;
  }
  for (std::uint32_t quarter = 0; quarter < 4; ++quarter) { // exact where they are whole numbers
    const auto [cosine, sine] = cosineSine(quarter << 30U);
    EXPECT_EQ(cosine, quarter == 0 ? 1.0 : quarter == 2 ? -1.0 : 0.0);
    EXPECT_EQ(sine, quarter == 1 ? 1.0 : quarter == 3 ? -1.0 : 0.0);
  }
}

TEST(Elementary, ExponentialIsThatOfTheLibrary) {
  for (double x = -700.0; x <= 0.0; x += 0.0371) {
    EXPECT_NEAR(exponential(x) / std::exp(x), 1.0, 1e-15) << x;
  }
  EXPECT_EQ(exponential(0.0), 1.0);
  EXPECT_EQ(exponential(-701.0), 0.0);
  EXPECT_EQ(exponential(-std::numeric_limits<double>::infinity()), 0.0);
  EXPECT_EQ(exponential(std::numeric_limits<double>::quiet_NaN()), 0.0);
}

// Columns of random numbers against one number at a time, for every instruction set.
TEST(RandomColumns, AreTheSameBitsAsOneByOne) {
  const RandomStream stream(0x123456789abcdefULL, 17, 3, RandomPurpose::Motion);
  constexpr std::uint32_t kFirst = 4294967000U; // the index wraps within
  for (const InstructionSet limit :
       {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
    const InstructionSetLimit limited(limit);
    for (const std::size_t count : {0U, 1U, 7U, 256U, 1000U}) {
      std::vector<std::vector<double>> normal(3, std::vector<double>(count));
      std::vector<std::vector<double>> four(4, std::vector<double>(count));
      stream.fillNormal4(kFirst, 7, static_cast<std::int64_t>(count),
                         {four[0].data(), four[1].data(), four[2].data(), four[3].data()});
      std::vector<std::vector<float>> exponential(4, std::vector<float>(count));
      stream.fillNormal3(kFirst, static_cast<std::int64_t>(count),
                         {normal[0].data(), normal[1].data(), normal[2].data()});
      stream.fillExponential4(kFirst, static_cast<std::int64_t>(count),
                              {exponential[0].data(), exponential[1].data(), exponential[2].data(),
                               exponential[3].data()});
      for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t index = kFirst + static_cast<std::uint32_t>(i);
        for (std::size_t part = 0; part < 4; ++part) {
          ASSERT_EQ(four[part][i], stream.normal4(index, 7)[part]) << i;
          ASSERT_EQ(exponential[part][i], stream.exponential4(index)[part]) << i;
        }
        const auto expected = stream.normal3(index);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          ASSERT_EQ(normal[axis][i], double{expected[axis]}) << i;
        }
      }
    }
  }
}

// Single precision rounds at 6e-8: three or four times that for what is made of a few operations.
TEST(ElementarySingle, LogarithmIsThatOfTheLibrary) {
  for (float x = 1e-10F; x < 1e10F; x *= 1.0037F) {
    const double expected = std::log(double{x});
    EXPECT_NEAR(double{logarithm(x)}, expected, 2e-7 * std::max(1.0, std::abs(expected))) << x;
  }
  for (float step = 1e-7F; step < 0.4F; step *= 1.1F) { // near 1 the relative error counts
    const float x = 1.0F - step;
    EXPECT_NEAR(double{logarithm(x)} / std::log(double{x}), 1.0, 2.5e-7) << step;
  }
  EXPECT_EQ(logarithm(1.0F), 0.0F);
}

TEST(ElementarySingle, CosineAndSineAreThoseInDoublePrecision) {
  for (std::uint64_t turn = 0; turn < (std::uint64_t{1} << 32U); turn += 99991) {
    const auto expected = cosineSine(static_cast<std::uint32_t>(turn));
    const auto [cosine, sine] = cosineSineSingle(static_cast<std::uint32_t>(turn));
    ASSERT_NEAR(double{cosine}, expected.cosine, 1.5e-7) << turn;
    ASSERT_NEAR(double{sine}, expected.sine, 1.5e-7) << turn;
  }
  for (std::uint32_t quarter = 0; quarter < 4; ++quarter) { // exact where they are whole numbers
    const auto [cosine, sine] = cosineSineSingle(quarter << 30U);
    EXPECT_EQ(cosine, quarter == 0 ? 1.0F : quarter == 2 ? -1.0F : 0.0F);
    EXPECT_EQ(sine, quarter == 1 ? 1.0F : quarter == 3 ? -1.0F : 0.0F);
  }
}

TEST(ElementarySingle, UnitIntervalIsRoundedToItsNeighbor) {
  for (const std::uint32_t word : {0U, 1U, 2U, 65535U, 65536U, 0x7FFFFFFFU, 0x80000000U, ~0U}) {
    const double exact = (word + 0.5) * 0x1.0p-32;
    EXPECT_NEAR(double{toUnitInterval(word)} / exact, 1.0, 0x1.0p-24) << word;
  }
  EXPECT_GT(toUnitInterval(0U), 0.0F); // its logarithm is finite
  EXPECT_LE(toUnitInterval(~0U), 1.0F);
}

// r² is twice a logarithm of relative error 3e-7, of a number rounded at 6e-8: r is off by at most
// half of 6e-7 r² + 1.2e-7, divided by r, and direction adds 1.5e-7 r.
TEST(RandomStream, NormalsInSinglePrecisionAreThoseInDouble) {
  const RandomStream stream(5, 0, 2, RandomPurpose::Motion);
  for (std::uint32_t i = 0; i < 200000; ++i) {
    const auto expected = stream.normal4(i);
    const auto found = stream.normal3(i);
    for (std::size_t a = 0; a < 3; ++a) {
      const double radius =
          a < 2 ? std::hypot(expected[0], expected[1]) : std::hypot(expected[2], expected[3]);
      ASSERT_NEAR(double{found[a]}, expected[a], 4.5e-7 * radius + 6e-8 / radius) << i;
    }
  }
}

} // namespace
} // namespace dewpoint::tests
