// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/hypothesis_numbers.h"

#include <gtest/gtest.h>

#include <set>

namespace dewpoint::tests {
namespace {

using tracking::HypothesisNumbers;

std::set<std::uint32_t> fiveThousand(HypothesisNumbers::Half half) {
  HypothesisNumbers numbers(half);
  std::set<std::uint32_t> given;
  for (int k = 0; k < 5000; ++k) {
    given.insert(numbers.next());
  }
  return given;
}

// Random numbers have room for 4096 hypotheses of a target.
TEST(HypothesisNumbers, StayInTheirHalfHoweverManyThereAre) {
  const auto ball = fiveThousand(HypothesisNumbers::Half::Ball);
  EXPECT_EQ(*ball.begin(), 1U);
  EXPECT_EQ(*ball.rbegin(), 2047U);
  const auto region = fiveThousand(HypothesisNumbers::Half::Region);
  EXPECT_EQ(*region.begin(), 2049U);
  EXPECT_EQ(*region.rbegin(), 4095U);
}

TEST(HypothesisNumbers, BeginAgainAtARestart) {
  HypothesisNumbers numbers(HypothesisNumbers::Half::Region);
  const auto first = numbers.next();
  EXPECT_EQ(numbers.next(), first + 1);
  numbers.restart();
  EXPECT_EQ(numbers.next(), first);
}

} // namespace
} // namespace dewpoint::tests
