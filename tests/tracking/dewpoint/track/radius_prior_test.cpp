// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/radius_prior.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(RadiusPrior, WithoutAnyKnowledgeEveryRadiusIsAsGood) {
  const RadiusPrior unknown;
  EXPECT_FALSE(unknown.isGiven());
  EXPECT_EQ(unknown.penaltyFor(0.01), 0.0);
  EXPECT_EQ(unknown.penaltyFor(10.0), 0.0);
  EXPECT_TRUE(unknown.allowsRadius(10.0));
  EXPECT_GT(unknown.expectedRadius(), 0.0);
}

// ln(1.1) = 0.0953 is 1.906 standard deviations of 0.05: half its square is 1.817. A quarter too
// large, 4.46, and too small, 5.75, reach the bound.
TEST(RadiusPrior, AGivenRadiusIsAGuess) {
  const RadiusPrior given(0.035);
  EXPECT_TRUE(given.isGiven());
  EXPECT_EQ(given.expectedRadius(), 0.035);
  EXPECT_EQ(given.penaltyFor(0.035), 0.0);
  EXPECT_NEAR(given.penaltyFor(1.1 * 0.035), 1.817, 1e-3);
  EXPECT_NEAR(given.penaltyFor(0.035 / 1.1), 1.817, 1e-3);
  EXPECT_EQ(given.penaltyFor(0.75 * 0.035), given.penaltyFor(1.25 * 0.035));
  EXPECT_EQ(given.logVariance(), 0.0); // it holds until an outline contradicts it
  EXPECT_GT(RadiusPrior().logVariance(), 0.0);
  EXPECT_FALSE(given.contradicts(1.05 * 0.035));
  EXPECT_TRUE(given.contradicts(1.07 * 0.035));
  EXPECT_FALSE(RadiusPrior().contradicts(1.0));
  RadiusPrior used(0.035);
  used.learn(0.035, 0.0); // as a track says of a radius that it does not measure
  EXPECT_TRUE(used.isTrusted());
}

// e^0.4 = 1.49: half or double the size is another object.
TEST(RadiusPrior, WhatIsFarTooLargeOrSmallIsAnotherObject) {
  const RadiusPrior given(0.035);
  for (const double factor : {0.68, 0.75, 1.25, 1.48}) {
    EXPECT_TRUE(given.allowsRadius(factor * 0.035)) << factor;
  }
  for (const double factor : {0.5, 0.66, 1.5, 2.0}) {
    EXPECT_FALSE(given.allowsRadius(factor * 0.035)) << factor;
  }
}

TEST(RadiusPrior, WhatWasMeasuredIsRememberedUntilARestart) {
  for (const double given : {0.0, 0.028}) {
    RadiusPrior prior(given);
    prior.learn(0.070, 0.04); // known to a fifth: too little
    EXPECT_NE(prior.expectedRadius(), 0.070) << given;
    prior.learn(0.070, 0.0); // not measured
    EXPECT_NE(prior.expectedRadius(), 0.070) << given;
    prior.learn(0.035, 0.0004); // to a fiftieth
    EXPECT_EQ(prior.expectedRadius(), 0.035) << given;
    EXPECT_GT(prior.logVariance(), 0.0) << given;
    EXPECT_EQ(prior.penaltyFor(0.035), 0.0) << given;
    EXPECT_FALSE(prior.allowsRadius(0.0175)) << given;
    prior.restart();
    EXPECT_EQ(prior.expectedRadius(), RadiusPrior(given).expectedRadius());
    EXPECT_EQ(prior.allowsRadius(0.0175), RadiusPrior(given).allowsRadius(0.0175));
  }
}

} // namespace
} // namespace dewpoint::tests
