// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/hypothesis_masses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace dewpoint::tests {
namespace {

// 8 against 1 + 1 and nothing there 2: 8 / 12.
TEST(ShareOfLargest, ByHand) {
  const std::vector<double> masses{std::log(1.0), std::log(8.0), std::log(1.0)};
  EXPECT_NEAR(shareOfLargest(masses, 2.0), 8.0 / 12.0, 1e-15);
}

// Two that are equal to the last bit are each other's rivals: neither is more than an even chance.
TEST(ShareOfLargest, ExactTiesAreRivals) {
  const std::vector<double> masses{-3.25, -3.25};
  EXPECT_NEAR(shareOfLargest(masses, 0.0), 0.5, 1e-15);
  EXPECT_LT(shareOfLargest(masses, 1e-9), 0.5);
}

TEST(ShareOfLargest, OneAloneCompetesWithAbsence) {
  EXPECT_NEAR(shareOfLargest(std::vector{std::log(3.0)}, 1.0), 0.75, 1e-15);
}

} // namespace
} // namespace dewpoint::tests
