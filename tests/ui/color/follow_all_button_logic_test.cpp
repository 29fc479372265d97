// SPDX-License-Identifier: GPL-3.0-or-later
// Several things of one color: each becomes a target.
#include "core/color/color_learning.h"
#include "core/project/project.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/color/follow_all_button.h"
#include "ui/document/document.h"

#include <QUndoStack>
#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

ColorAssessment threeAlike() {
  ColorAssessment assessment;
  assessment.similarObjectCount = 3;
  assessment.suggestion = ColorSuggestion::FollowAll;
  return assessment;
}

class FollowAllButtonTest : public ::testing::Test {
protected:
  FollowAllButtonTest() {
    Project project;
    project.scene = "demo";
    project.parameters = ParameterValues(methodParameters(project.method));
    project.targets.push_back({"ball", 0.02, {300.0, 340.0, 0.2, 0.9, 0.1, 0.9}});
    project.targets.front().samples.resize(1);
    document_.replaceProject(project);
  }
  const std::vector<Target>& targets() const { return document_.project().targets; }

  Document document_;
  FollowAllButton button_{document_};
};

TEST_F(FollowAllButtonTest, AddsATargetForEachOfTheOthersAsOneStep) {
  EXPECT_FALSE(button_.isOffering());
  const ColorAssessment assessment = threeAlike();
  button_.offer(&assessment, 0);
  EXPECT_TRUE(button_.isOffering());
  EXPECT_TRUE(button_.text().contains(QStringLiteral("3")));
  button_.click();
  ASSERT_EQ(targets().size(), 3U);
  EXPECT_EQ(targets()[1].colors(), targets()[0].colors());
  EXPECT_EQ(targets()[2].radius, targets()[0].radius);
  EXPECT_TRUE(targets()[2].samples.empty());
  EXPECT_NE(targets()[1].name, targets()[2].name);
  // Each has its target now.
  button_.offer(&assessment, 0);
  EXPECT_FALSE(button_.isOffering());
  document_.undoStack()->undo();
  EXPECT_EQ(targets().size(), 1U);
  EXPECT_FALSE(document_.undoStack()->canUndo());
}

TEST_F(FollowAllButtonTest, OffersNothingElse) {
  ColorAssessment assessment = threeAlike();
  assessment.suggestion = ColorSuggestion::RemoveDistractor;
  button_.offer(&assessment, 0);
  EXPECT_FALSE(button_.isOffering());
  assessment.suggestion = ColorSuggestion::FollowAll;
  button_.offer(&assessment, -1); // a new target
  EXPECT_FALSE(button_.isOffering());
  button_.offer(nullptr, 0);
  EXPECT_FALSE(button_.isOffering());
}

} // namespace
} // namespace dewpoint::tests
