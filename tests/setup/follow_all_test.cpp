// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/follow_all.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

Target pinkBall() {
  Target ball{"ball", 0.02, {300.0, 340.0, 0.2, 0.9, 0.1, 0.9}};
  ball.samples.resize(1);
  return ball;
}

Project twoBalls() {
  Project project;
  project.targets = {pinkBall(), {"other", 0.02, {100.0, 140.0, 0.2, 0.9, 0.1, 0.9}}};
  return project;
}

ColorAssessment alike(int count) {
  ColorAssessment assessment;
  assessment.similarObjectCount = count;
  assessment.suggestion = ColorSuggestion::FollowAll;
  return assessment;
}

std::string numbered(std::size_t number) {
  return "target " + std::to_string(number);
}

TEST(FollowAll, WhatHasItsTargetIsNotMissing) {
  Project project = twoBalls();
  EXPECT_EQ(setup::missingTargetCount(project, 0, alike(4)), 3);
  project.targets.push_back(pinkBall());
  EXPECT_EQ(setup::missingTargetCount(project, 0, alike(4)), 2);
  EXPECT_EQ(setup::missingTargetCount(project, 0, alike(1)), 0);
}

TEST(FollowAll, TargetsOfSeveralColorsAreOthers) {
  Project project = twoBalls();
  project.targets[1] = pinkBall();
  project.targets[1].otherColors = {{100.0, 140.0, 0.2, 0.9, 0.1, 0.9}};
  EXPECT_EQ(setup::missingTargetCount(project, 0, alike(2)), 1);
}

TEST(FollowAll, NothingIsMissingWithoutTheSuggestion) {
  ColorAssessment assessment = alike(4);
  EXPECT_EQ(setup::missingTargetCount(twoBalls(), 2, assessment), 0); // there is no such target
  assessment.suggestion = ColorSuggestion::RemoveDistractor;
  EXPECT_EQ(setup::missingTargetCount(twoBalls(), 0, assessment), 0);
}

TEST(FollowAll, OthersAreLikeTheOneWithNamesOfTheirOwn) {
  Project project = twoBalls();
  setup::addTargetCopies(project, 0, 2,
                         [](const Project& now) { return setup::unusedTargetName(now, numbered); });
  ASSERT_EQ(project.targets.size(), 4U);
  EXPECT_EQ(project.targets[2].name, "target 3");
  EXPECT_EQ(project.targets[3].name, "target 4");
  EXPECT_EQ(project.targets[3].colors(), project.targets[0].colors());
  EXPECT_EQ(project.targets[3].radius, 0.02);
  EXPECT_TRUE(project.targets[3].samples.empty()); // they show the one
  EXPECT_EQ(setup::missingTargetCount(project, 0, alike(3)), 0);
}

TEST(FollowAll, TakenNamesAreLeftOut) {
  Project project = twoBalls();
  project.targets[0].name = "target 3";
  EXPECT_EQ(setup::unusedTargetName(project, numbered), "target 4");
}

} // namespace
} // namespace dewpoint::tests
