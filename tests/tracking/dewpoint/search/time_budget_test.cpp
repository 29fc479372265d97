// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/search/time_budget.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

using Stage = TimeBudget::Stage;
constexpr double kFemtosecond = 1e-12; ///< milliseconds; passed before it can be asked for
constexpr double kDay = 86.4e6;        ///< milliseconds

TimeBudget begun(double milliseconds) {
  TimeBudget budget;
  budget.setLimit(milliseconds);
  budget.beginIteration();
  return budget;
}

TEST(TimeBudget, WithoutALimitEverythingIsDone) {
  TimeBudget budget = begun(0.0);
  int done = 0;
  for (int k = 0; k < 100; ++k) {
    EXPECT_TRUE(budget.runIfAffordable(Stage::Labels, [&] { ++done; }));
  }
  budget.adaptParticleCount(2000.0);
  EXPECT_EQ(done, 100);
  EXPECT_FALSE(budget.isLimited());
  EXPECT_FALSE(budget.affordableParticleCount());
}

TEST(TimeBudget, WhatFitsIsDone) {
  TimeBudget budget = begun(kDay);
  int done = 0;
  for (int k = 0; k < 100; ++k) {
    EXPECT_TRUE(budget.runIfAffordable(Stage::Labels, [&] { ++done; }));
  }
  EXPECT_EQ(done, 100);
}

TEST(TimeBudget, WhatDoesNotFitIsPutOffButNotForGood) {
  TimeBudget budget = begun(kFemtosecond);
  int done = 0;
  for (int k = 0; k < TimeBudget::kMaxDeferrals; ++k) {
    EXPECT_FALSE(budget.runIfAffordable(Stage::Learning, [&] { ++done; }));
  }
  EXPECT_TRUE(budget.runIfAffordable(Stage::Learning, [&] { ++done; }));
  EXPECT_FALSE(budget.runIfAffordable(Stage::Learning, [&] { ++done; })); // and waits again
  EXPECT_FALSE(budget.runIfAffordable(Stage::Spots, [&] { ++done; }));    // each part for itself
  EXPECT_EQ(done, 1);
}

TEST(TimeBudget, UrgentWorkIsDoneAtOnce) {
  TimeBudget budget = begun(kFemtosecond);
  bool done = false;
  EXPECT_TRUE(budget.runIfAffordable(
      Stage::Candidates, [&] { done = true; }, true));
  EXPECT_TRUE(done);
}

TEST(TimeBudget, ParticlesFallAtOnceDownToTen) {
  TimeBudget budget = begun(kFemtosecond);
  EXPECT_FALSE(budget.affordableParticleCount()); // nothing is known yet
  budget.adaptParticleCount(2000.0);
  EXPECT_EQ(budget.affordableParticleCount(), 500.0); // by four at most
  budget.adaptParticleCount(2000.0);
  EXPECT_EQ(budget.affordableParticleCount(), 125.0);
  for (int k = 0; k < 3; ++k) {
    budget.adaptParticleCount(2000.0);
  }
  EXPECT_EQ(budget.affordableParticleCount(), 10.0);
}

TEST(TimeBudget, ParticlesRiseSlowlyToTheMost) {
  TimeBudget budget = begun(kDay);
  budget.adaptParticleCount(100.0);
  EXPECT_EQ(budget.affordableParticleCount(), 100.0);
  budget.adaptParticleCount(2000.0);
  EXPECT_DOUBLE_EQ(*budget.affordableParticleCount(), 110.0);
}

TEST(TimeBudget, AnotherLimitForgetsTheOld) {
  TimeBudget budget = begun(kFemtosecond);
  budget.adaptParticleCount(2000.0);
  budget.setLimit(kFemtosecond);
  EXPECT_TRUE(budget.affordableParticleCount()); // the same again changes nothing
  budget.setLimit(kDay);
  EXPECT_FALSE(budget.affordableParticleCount());
}

} // namespace
} // namespace dewpoint::tests
