// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace dewpoint::tests {
namespace {

TEST(TextNumber, IsTheWholeText) {
  EXPECT_EQ(base::toNumber<int>("-12"), -12);
  EXPECT_EQ(base::toNumber<std::uint64_t>("18446744073709551615"), 18446744073709551615U);
  EXPECT_EQ(base::toNumber<double>("2.5e-3"), 2.5e-3);
  EXPECT_EQ(base::toNumber<double>("0.1"), 0.1);

  for (const char* text : {"", " 1", "1 ", "+1", "1,5", "1px", "x", "-"}) {
    EXPECT_FALSE(base::toNumber<double>(text)) << text;
    EXPECT_FALSE(base::toNumber<int>(text)) << text;
  }
  EXPECT_FALSE(base::toNumber<int>("1.5"));
}

TEST(TextNumber, HasToFitItsType) {
  EXPECT_FALSE(base::toNumber<std::int32_t>("2147483648"));
  EXPECT_FALSE(base::toNumber<std::uint64_t>("-1"));
  EXPECT_FALSE(base::toNumber<double>("1e999"));
}

TEST(TextNumber, MayBeInfinityOrNone) {
  EXPECT_TRUE(std::isinf(base::toNumber<double>("inf").value()));
  EXPECT_TRUE(std::isnan(base::toNumber<double>("nan").value()));
}

} // namespace
} // namespace dewpoint::tests
