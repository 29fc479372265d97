// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/doctor/finding.h"

#include <gtest/gtest.h>

#include <set>

namespace dewpoint::tests {
namespace {

TEST(Finding, EachKindHasItsWordsAndAnAdviceWhereSomethingIsWrong) {
  std::set<std::string_view> names;
  int number = 0;
  for (const FindingTexts& words : findingTexts()) {
    EXPECT_EQ(static_cast<int>(words.kind), number++)
        << words.name << ": in the order of the kinds";
    EXPECT_TRUE(names.insert(words.name).second) << words.name;
    EXPECT_TRUE(words.description.ends_with('.')) << words.description;
    const bool isFine = words.level == FindingLevel::Ok;
    const bool saysWhatToDo = !words.advice.empty() || words.kind == FindingKind::CamerasDisagree;
    EXPECT_EQ(saysWhatToDo, !isFine) << words.name;
    EXPECT_EQ(&textsOf(words.kind), &words);
  }
  EXPECT_EQ(number, static_cast<int>(FindingKind::FolderUnwritable) + 1);
}

TEST(Finding, IsOneLineWithLevelPlaceAndAdvice) {
  const Finding finding{FindingKind::RecordingMissing,
                        {"camera 'left'", "/clips/left.mp4"},
                        "desk.toml",
                        "camera 1.video"};
  EXPECT_EQ(
      findingLine(finding),
      "problem  The recording of camera 'left' is missing: /clips/left.mp4. (desk.toml: "
      "camera 1.video) Put the missing file or folder back, or correct its path in the project "
      "file.");
  EXPECT_EQ(findingLine({FindingKind::MethodFits, {"dewpoint"}}),
            "ok       The method dewpoint can work with this project.");
}

TEST(Finding, PlacesAreFilledOnceAndSentencesBeginWithACapital) {
  EXPECT_EQ(fillPlaceholders("%1 has %2.", {"camera 1", "%1"}), "Camera 1 has %1.");
  EXPECT_EQ(fillPlaceholders("100 % of %1, %3", {"a"}), "100 % of a, %3");
}

TEST(Finding, TheWorstDecides) {
  EXPECT_EQ(worstLevelOf({}), FindingLevel::Ok);
  EXPECT_EQ(worstLevelOf({{FindingKind::ProjectRead}, {FindingKind::LengthsDiffer}}),
            FindingLevel::Note);
  EXPECT_EQ(worstLevelOf({{FindingKind::RatesDiffer}, {FindingKind::ProjectRead}}),
            FindingLevel::Problem);
}

} // namespace
} // namespace dewpoint::tests
