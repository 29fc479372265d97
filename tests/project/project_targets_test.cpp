// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_check.h"
#include "core/project/project_targets.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

Target named(const std::string& name) {
  Target target;
  target.name = name;
  return target;
}

TEST(ProjectTargets, CorrectionsGoWithTheirTargets) {
  Project project;
  project.targets = {named("a"), named("b"), named("c")};
  for (const int target : {0, 1, 2, 1}) {
    PositionCorrection& correction = project.corrections.emplace_back();
    correction.frame = static_cast<std::int64_t>(project.corrections.size());
    correction.target = target;
  }
  replaceTargets(project, {named("b"), named("d"), named("a")});
  EXPECT_EQ(project.targets.at(1).name, "d");
  ASSERT_EQ(project.corrections.size(), 3U); // that of c has gone
  EXPECT_EQ(project.corrections[0].target, 2);
  EXPECT_EQ(project.corrections[1].target, 0);
  EXPECT_EQ(project.corrections[2].target, 0);
  EXPECT_EQ(project.corrections[2].frame, 4);
}

TEST(ProjectTargets, AMethodMayMissThem) {
  Project project;
  project.method = "dewpoint";
  const auto none = checkMethodTargets(project);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::MissingKey);
  EXPECT_EQ(none.error().field, "target");
  project.targets = {named("ball")};
  EXPECT_TRUE(checkMethodTargets(project));
  project.method = "histogram"; // follows boxes
  EXPECT_FALSE(checkMethodTargets(project));
  project.method = "people"; // finds them by itself
  EXPECT_TRUE(checkMethodTargets(project));
}

} // namespace
} // namespace dewpoint::tests
