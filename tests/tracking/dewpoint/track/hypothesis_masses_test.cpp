// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/hypothesis_masses.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

constexpr double kHypothesisRadius = 0.04;

/// A hypothesis on the x axis, fully seen: its evidence is all it can be.
TrackHypothesis at(double x, double probability, int updateCount = 5) {
  TrackHypothesis hypothesis;
  hypothesis.gaussian.mean << x, 0.0, 0.0, 0.0, 0.0, 0.0;
  hypothesis.radius = kHypothesisRadius;
  hypothesis.probability = probability;
  hypothesis.wasOutlineFound = true;
  hypothesis.logLikelihoodRatio = 100.0;
  hypothesis.fullyVisibleLogLikelihoodRatio = 100.0;
  hypothesis.updateCount = updateCount;
  return hypothesis;
}

std::vector<double> probabilitiesOf(const std::vector<TrackHypothesis>& hypotheses) {
  std::vector<double> all;
  for (const TrackHypothesis& hypothesis : hypotheses) {
    all.push_back(hypothesis.probability);
  }
  return all;
}

TEST(HypothesisMasses, AbsenceIsWhatTheHypothesesLeave) {
  EXPECT_EQ(absenceProbability({}), 1.0);
  EXPECT_NEAR(absenceProbability({at(0, 0.5), at(1, 0.3)}), 0.2, 1e-15);
  // Predicted hypotheses that were merged and rounded may have a little more than all.
  EXPECT_EQ(absenceProbability({at(0, 0.7), at(1, 0.3001)}), 1e-9);
}

TEST(HypothesisMasses, WhatOneCameraShowsLeavesAbsenceToTheOthers) {
  std::vector<TrackHypothesis> all{at(0, 0.5), at(1, 0.3)};
  all[1].onlyOneCameraSees = true;
  EXPECT_NEAR(absenceProbabilityInSharedViews(all), 0.5, 1e-15);
  EXPECT_NEAR(absenceProbability(all), 0.2, 1e-15);
}

TEST(HypothesisMasses, OneCameraGivesBackWhatWasProvenAndNoMore) {
  std::vector<TrackHypothesis> all{at(0, 0.6)};
  limitOneCameraHypotheses(all); // two cameras see it: 0.6 is proven
  all[0].onlyOneCameraSees = true;
  all[0].probability = 0.3; // time has passed
  limitOneCameraHypotheses(all);
  EXPECT_EQ(all[0].probability, 0.3);
  all[0].probability = 0.9; // what one camera says of it
  limitOneCameraHypotheses(all);
  EXPECT_EQ(all[0].probability, 0.6);
}

TEST(HypothesisMasses, WhatMayBeAPartOfSomethingLargerIsNeverSure) {
  std::vector<TrackHypothesis> all{at(0, 0.99), at(1, 0.99), at(2, 0.99), at(3, 0.5)};
  all[0].wasRimSeen = true;
  all[1].wasRimSeen = true;
  all[1].secondsSinceRimSeen = TrackHypothesis::kRimMemorySeconds + 0.01; // for too long
  limitHypothesesWithoutRim(all);
  EXPECT_EQ(probabilitiesOf(all), (std::vector<double>{0.99, 0.9, 0.9, 0.5}));
}

TEST(HypothesisMasses, RivalsThatFitAboutAsWellLeaveItUndecided) {
  EXPECT_FALSE(isUndecided({}));
  EXPECT_FALSE(isUndecided({at(0, 1.0)}));
  EXPECT_FALSE(isUndecided({at(0, 0.95), at(1, 0.04)}));
  EXPECT_TRUE(isUndecided({at(0, 0.6), at(1, 0.2)}));
  EXPECT_TRUE(isUndecided({at(0, 0.4), at(1, 0.3)}));
  EXPECT_FALSE(isUndecided({at(0, 0.02), at(1, 0.02)})); // it is likelier not to be there at all
}

// A quarter of the probability is 2 m away: 0.25 x 2² = 1 m² more along the x axis.
TEST(HypothesisMasses, TheMixtureSpansAllPositions) {
  std::vector<TrackHypothesis> all{at(0, 0.6), at(2, 0.2)};
  for (TrackHypothesis& one : all) {
    one.gaussian.covariance.setIdentity();
    one.gaussian.covariance *= 1e-4;
  }
  const Eigen::Matrix3d expected =
      1e-4 * Eigen::Matrix3d::Identity() + Eigen::Vector3d(1, 0, 0).asDiagonal().toDenseMatrix();
  EXPECT_LT((mixtureCovariance(all) - expected).norm(), 1e-12);
}

// Priors 0.5, 0.3 and 0.2 for "not there"; the images make the first four times likelier than
// "not there" and say nothing of the second: masses 2, 0.3, 0.2 of 2.5 in all.
TEST(HypothesisMasses, ProbabilitiesAreShareOfAllMass) {
  std::vector<TrackHypothesis> all{at(0, 0.5), at(1, 0.3)};
  normalizeMasses(all, {std::log(0.5 * 4.0), std::log(0.3)});
  EXPECT_NEAR(all[0].probability, 0.80, 1e-12);
  EXPECT_NEAR(all[1].probability, 0.12, 1e-12);
  EXPECT_NEAR(absenceProbability(all), 0.08, 1e-12);
}

// Bayes' rule twice with ratios 4 and 1/2 is once with 2: odds 0.5 : 0.5 become 2 : 1.
TEST(HypothesisMasses, TwoMeasurementsAreOneWithTheProductOfTheirRatios) {
  std::vector<TrackHypothesis> all{at(0, 0.5)};
  for (const double ratio : {4.0, 0.5}) {
    normalizeMasses(all, {std::log(all[0].probability * ratio)});
  }
  EXPECT_NEAR(all[0].probability, 2.0 / 3.0, 1e-12);
}

TEST(HypothesisMasses, MassesMayBeAnyNumberOfDecadesApart) {
  // exp(1000) is no number: of two such masses, e² apart, the first has 1 / (1 + e⁻²).
  std::vector<TrackHypothesis> high{at(0, 0.4), at(1, 0.4)};
  normalizeMasses(high, {1000.0, 998.0});
  EXPECT_NEAR(high[0].probability, 1.0 / (1.0 + std::exp(-2.0)), 1e-12);
  EXPECT_NEAR(high[1].probability, 1.0 / (1.0 + std::exp(2.0)), 1e-12);
  // And nothing is left of what e⁻¹⁰⁰⁰ was.
  std::vector<TrackHypothesis> low{at(0, 0.8)};
  normalizeMasses(low, {-1000.0});
  EXPECT_EQ(low[0].probability, 0.0);
  std::vector<TrackHypothesis> none;
  normalizeMasses(none, {});
  EXPECT_TRUE(none.empty());
}

TEST(HypothesisMasses, EvidenceCountsUpToThreeQuartersOfTheBest) {
  TrackHypothesis hypothesis = at(0, 0.5);
  hypothesis.logLikelihoodRatio = 90.0; // of 100: 15 beyond 75
  EXPECT_NEAR(evidenceBeyondSaturation(hypothesis), 15.0, 1e-12);
  hypothesis.logLikelihoodRatio = 60.0;
  EXPECT_EQ(evidenceBeyondSaturation(hypothesis), 0.0);
}

// 8 against 1 + 1 and nothing there 2: 8 / 12.
TEST(ShareOfLargest, ByHand) {
  const std::vector<double> masses{std::log(1.0), std::log(8.0), std::log(1.0)};
  EXPECT_NEAR(probabilityOfMostLikely(masses, 2.0), 8.0 / 12.0, 1e-15);
}

// Two that are equal to the last bit are each other's rivals: neither is more than an even chance.
TEST(ShareOfLargest, ExactTiesAreRivals) {
  const std::vector<double> masses{-3.25, -3.25};
  EXPECT_NEAR(probabilityOfMostLikely(masses, 0.0), 0.5, 1e-15);
  EXPECT_LT(probabilityOfMostLikely(masses, 1e-9), 0.5);
}

TEST(ShareOfLargest, OneAloneCompetesWithAbsence) {
  EXPECT_NEAR(probabilityOfMostLikely(std::vector{std::log(3.0)}, 1.0), 0.75, 1e-15);
}

TEST(HypothesisMasses, NothingBelievedMustBeSearchedFor) {
  EXPECT_TRUE(mustSearch({}, {}));
}

// "Not there" has 0.1. A mass m is 0.98 of m + 0.1 at m = 4.9.
TEST(HypothesisMasses, SearchesWhileLessThan98PercentOfTheMassIsInOnePlace) {
  const std::vector<TrackHypothesis> one{at(0, 0.9)};
  EXPECT_TRUE(mustSearch(one, {std::log(4.89)}));
  EXPECT_FALSE(mustSearch(one, {std::log(4.91)}));
  // A second position with 0.1 more: 0.98 of m + 0.2 at m = 9.8. The order does not matter.
  const std::vector<TrackHypothesis> two{at(0, 0.85), at(1, 0.05)};
  EXPECT_TRUE(mustSearch(two, {std::log(9.79), std::log(0.1)}));
  EXPECT_FALSE(mustSearch(two, {std::log(9.81), std::log(0.1)}));
  EXPECT_FALSE(mustSearch(two, {std::log(0.1), std::log(9.81)}));
}

// Two places with the same mass to the last bit: neither is sure, however little else there is.
TEST(HypothesisMasses, SearchesWhereTwoPlacesTieExactly) {
  const std::vector<TrackHypothesis> two{at(0, 0.5), at(1, 0.5)};
  EXPECT_TRUE(mustSearch(two, {10.0, 10.0}));
}

TEST(HypothesisMasses, SearchesWhatIsNotWellSeenHoweverSure) {
  const std::vector<double> sure{std::log(1e6)};
  std::vector<TrackHypothesis> one{at(0, 0.9)};
  one[0].logLikelihoodRatio = 54.0; // of 100, where 55 are asked for
  EXPECT_TRUE(mustSearch(one, sure));
  one[0].logLikelihoodRatio = 56.0;
  EXPECT_FALSE(mustSearch(one, sure));
  one[0].logLikelihoodRatio = one[0].fullyVisibleLogLikelihoodRatio =
      0.0; // no camera can see that position
  EXPECT_TRUE(mustSearch(one, sure));
}

TEST(HypothesisMasses, TheLikeliestIsFirstAndEqualOnesKeepTheirOrder) {
  std::vector<TrackHypothesis> all{at(0, 0.1), at(1, 0.3), at(2, 0.1), at(3, 0.4)};
  mergeAndPrune(all);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].position().x(), 3.0);
  EXPECT_EQ(all[1].position().x(), 1.0);
  EXPECT_EQ(all[2].position().x(), 0.0);
  EXPECT_EQ(all[3].position().x(), 2.0);
}

// Half a radius is 2 cm.
TEST(HypothesisMasses, PlacesCloserThanHalfARadiusAreOne) {
  std::vector<TrackHypothesis> near{at(0.019, 0.2), at(0, 0.6)};
  mergeAndPrune(near);
  ASSERT_EQ(near.size(), 1U);
  EXPECT_EQ(near[0].position().x(), 0.0); // of the likelier one
  EXPECT_NEAR(near[0].probability, 0.8, 1e-15);
  std::vector<TrackHypothesis> apart{at(0.021, 0.2), at(0, 0.6)};
  mergeAndPrune(apart);
  EXPECT_EQ(probabilitiesOf(apart), (std::vector<double>{0.6, 0.2}));
}

TEST(HypothesisMasses, SixPlacesAreKeptAndNoneThatIsAsGoodAsImpossible) {
  std::vector<TrackHypothesis> many;
  for (int k = 0; k < 8; ++k) {
    many.push_back(at(k, 0.1 + 0.001 * k));
  }
  mergeAndPrune(many);
  ASSERT_EQ(many.size(), 6U);
  EXPECT_EQ(many.back().position().x(), 2.0); // 0 and 1 were the least likely
  std::vector<TrackHypothesis> faint{at(0, 0.9), at(1, 1e-8), at(2, 1.1e-8), at(0.001, 1e-9)};
  mergeAndPrune(faint);
  ASSERT_EQ(faint.size(), 2U);
  EXPECT_EQ(faint[1].position().x(), 2.0);
  EXPECT_EQ(faint[0].probability, 0.9 + 1e-9); // what is merged counts, however little
}

// Radii 4 and 6 cm: centers closer than 0.7 (4 + 6) = 7 cm.
TEST(HypothesisMasses, SpheresDoNotOverlap) {
  const std::vector<OccupiedSphere> occupied{{{1.0, 0.0, 0.0}, 0.06}, {{0.0, 2.0, 0.0}, 0.06}};
  EXPECT_TRUE(isOccupied({1.0, 0.0, 0.069}, kHypothesisRadius, occupied));
  EXPECT_FALSE(isOccupied({1.0, 0.0, 0.071}, kHypothesisRadius, occupied));
  EXPECT_TRUE(isOccupied({0.0, 1.931, 0.0}, kHypothesisRadius, occupied));
  EXPECT_FALSE(isOccupied({1.0, 0.0, 0.0}, kHypothesisRadius, {}));
}

// 0.6 for the one that is chosen, 0.3 for its rival: wrong with 0.3 / 0.9. The third was seen for
// four frames only, and the fourth is not fully seen: nothing is decided about them.
TEST(HypothesisMasses, OfPlacesThatAreFullySeenForLongTheLikeliestIsChosen) {
  std::vector<TrackHypothesis> all{at(0, 0.6), at(1, 0.3), at(2, 0.06, 4), at(3, 0.02)};
  all[3].logLikelihoodRatio = 74.0; // of 100, where 75 are asked for
  const auto ambiguity = resolveAmbiguity(all);
  ASSERT_TRUE(ambiguity);
  EXPECT_NEAR(*ambiguity, 1.0 / 3.0, 1e-12);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_NEAR(all[0].probability, 0.9, 1e-12);
  EXPECT_EQ(all[1].position().x(), 2.0);
  EXPECT_EQ(all[2].position().x(), 3.0);
}

TEST(HypothesisMasses, NothingIsChosenTooEarlyOrWithoutARival) {
  std::vector<TrackHypothesis> alone{at(0, 0.9)};
  EXPECT_FALSE(resolveAmbiguity(alone));
  std::vector<TrackHypothesis> early{at(0, 0.6, 4), at(1, 0.3)};
  EXPECT_FALSE(resolveAmbiguity(early));
  std::vector<TrackHypothesis> hidden{at(0, 0.6), at(1, 0.3)};
  hidden[0].wasOutlineFound = false;
  EXPECT_FALSE(resolveAmbiguity(hidden));
  EXPECT_EQ(probabilitiesOf(hidden), (std::vector<double>{0.6, 0.3}));
  // Others that are hidden are no rivals: sure, and nothing is dropped.
  std::vector<TrackHypothesis> clear{at(0, 0.6), at(1, 0.3)};
  clear[1].wasOutlineFound = false;
  EXPECT_EQ(resolveAmbiguity(clear), 0.0);
  EXPECT_EQ(clear.size(), 2U);
}

} // namespace
} // namespace dewpoint::tests
