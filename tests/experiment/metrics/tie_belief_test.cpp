// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/tie_belief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace dewpoint::tests {
namespace {

ReportedBelief beliefOf(double probability, bool declared = true) {
  ReportedBelief belief;
  belief.probability = probability;
  belief.isDeclared = declared;
  belief.truth = Eigen::Vector3d::Zero(); // it is right, by luck
  return belief;
}

TEST(TieBelief, IsSureAboveOneOverTheCandidatesPlusTheSlack) {
  EXPECT_FALSE(isConfidentInTie(beliefOf(0.5), 2));
  EXPECT_FALSE(isConfidentInTie(beliefOf(0.5 + kTieMargin - 1e-6), 2));
  EXPECT_TRUE(isConfidentInTie(beliefOf(0.5 + kTieMargin + 1e-6), 2));
  EXPECT_TRUE(isConfidentInTie(beliefOf(0.5), 3)) << "one third is all that can be known";
  EXPECT_FALSE(isConfidentInTie(beliefOf(0.25), 4));
  EXPECT_TRUE(isConfidentInTie(beliefOf(1.0), 2)) << "to be right is no excuse";
}

TEST(TieBelief, WhatIsNotDeclaredClaimsNothing) {
  EXPECT_FALSE(isConfidentInTie(beliefOf(0.9, false), 2));
}

TEST(TieBelief, WithoutEqualCandidatesNobodyIsTooSure) {
  EXPECT_FALSE(isConfidentInTie(beliefOf(1.0), 1));
}

TEST(TieBelief, SharesAreOfAllBeliefs) {
  const std::vector<ReportedBelief> beliefs{beliefOf(0.5), beliefOf(0.7), beliefOf(0.99),
                                            beliefOf(0.0, false), beliefOf(0.52)};
  const Proportion share = confidentInTieShare(beliefs, 2);
  EXPECT_EQ(share.count, 2);
  EXPECT_EQ(share.total, 5);
  EXPECT_TRUE(std::isnan(confidentInTieShare({}, 2).value()));
}

} // namespace
} // namespace dewpoint::tests
