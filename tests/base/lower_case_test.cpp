// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/lower_case.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(LowerCase, IsThatOfTheLettersAToZ) {
  EXPECT_EQ(base::toLowerCase(".JPeG"), ".jpeg");
  EXPECT_EQ(base::toLowerCase("@AZ[`az{ 09_"), "@az[`az{ 09_");
  EXPECT_EQ(base::toLowerCase(""), "");
  EXPECT_EQ(base::toLowerCase("\xC3\x84 A"), "\xC3\x84 a"); // an umlaut stays as it is
}

} // namespace
} // namespace dewpoint::tests
