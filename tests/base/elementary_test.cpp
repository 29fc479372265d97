// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/elementary.h"
#include "core/base/instruction_set.h"
#include "core/base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace dewpoint {
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
      std::vector<double> uniform(count);
      std::vector<std::vector<double>> normal(3, uniform);
      stream.uniforms(kFirst, static_cast<std::int64_t>(count), uniform.data());
      stream.normals(kFirst, static_cast<std::int64_t>(count),
                     {normal[0].data(), normal[1].data(), normal[2].data()});
      for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t index = kFirst + static_cast<std::uint32_t>(i);
        ASSERT_EQ(uniform[i], stream.uniform(index)) << i;
        const auto expected = stream.normal4(index);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          ASSERT_EQ(normal[axis][i], expected[axis]) << i;
        }
      }
    }
  }
}

} // namespace
} // namespace dewpoint
