// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/clips/clip_catalog.h"
#include "core/experiment/clips/real_scenarios.h"
#include "tests/capture/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

fs::path recordings() {
  const char* data = std::getenv("DEWPOINT_DATA");
  return data != nullptr ? fs::path(data) : fs::path();
}

TEST(ClipCatalog, HasCompleteRows) {
  std::set<std::string> names;
  for (const ClipDeclaration& clip : clipCatalog()) {
    EXPECT_TRUE(names.insert(clip.name).second) << clip.name << " is there twice";
    EXPECT_TRUE(clip.name.starts_with(clip.calibrated ? "R1-" : "R2-")) << clip.name;
    EXPECT_NE(clip.calibrated == nullptr, clip.images == nullptr) << clip.name;
    for (const std::string& text : {clip.recording, clip.description, clip.learningDescription,
                                    clip.truthDescription, clip.tuningNote}) {
      EXPECT_FALSE(text.empty()) << clip.name;
    }
    EXPECT_TRUE(clip.description.ends_with('.') && clip.learningDescription.ends_with('.'))
        << clip.name;
    EXPECT_GT(clip.truthSigma, 0.0) << clip.name;
    EXPECT_GT(clip.seedCount, 0) << clip.name;
    EXPECT_EQ(clip.name.find(','), std::string::npos) << "the name is a cell of runs.csv";
  }
  EXPECT_GE(names.size(), 12U);
}

TEST(ClipCatalog, KnowsEveryRecording) {
  if (!fs::is_directory(recordings())) {
    GTEST_SKIP() << "there are no recordings in DEWPOINT_DATA";
  }
  std::set<std::string> known;
  for (const ClipDeclaration& clip : clipCatalog()) {
    known.insert(clip.recording);
  }
  for (const OmittedRecording& recording : omittedRecordings()) {
    EXPECT_TRUE(known.insert(recording.recording).second) << recording.recording;
    EXPECT_FALSE(recording.reason.empty()) << recording.recording;
  }
  for (const auto& entry : fs::directory_iterator(recordings())) {
    if (entry.is_directory() && !entry.path().filename().string().starts_with('.')) {
      EXPECT_TRUE(known.contains(entry.path().filename().string()))
          << entry.path() << " is neither a clip nor left out with a reason";
    }
  }
}

TEST(RealScenarios, SayWhatIsSkippedByName) {
  const test::TemporaryFolder folder;
  fs::create_directories(folder / "juggle1");
  const auto real = makeRealScenarios({folder / "", folder / "no truth"}, clipCatalog());
  EXPECT_EQ(real.scenarios.size(), 3U) << "the three balls of juggle1";
  EXPECT_EQ(real.scenarios.size() + real.skippedClips.size(), clipCatalog().size());
  const auto hand = std::ranges::find(real.skippedClips, "R1-hand", &SkippedClip::name);
  ASSERT_NE(hand, real.skippedClips.end());
  EXPECT_TRUE(hand->description.starts_with("R1-hand is skipped: ")) << hand->description;
  EXPECT_NE(hand->description.find("hand2_desk"), std::string::npos) << hand->description;

  fs::create_directories(folder / "hand2_desk");
  const auto more = makeRealScenarios({folder / "", folder / "no truth"}, clipCatalog());
  const auto again = std::ranges::find(more.skippedClips, "R1-hand", &SkippedClip::name);
  ASSERT_NE(again, more.skippedClips.end()) << "its truth is missing as well";
  EXPECT_NE(again->description.find("no truth"), std::string::npos) << again->description;

  const auto none = makeRealScenarios({}, clipCatalog());
  EXPECT_TRUE(none.scenarios.empty());
  EXPECT_EQ(none.skippedClips.size(), clipCatalog().size());
}

TEST(RealScenarios, AreOfOneGradeAndSayWhatWasTuned) {
  const test::TemporaryFolder folder;
  fs::create_directories(folder / "juggle1");
  const auto real = makeRealScenarios({folder / "", {}}, clipCatalog());
  ASSERT_FALSE(real.scenarios.empty());
  const ScenarioDeclaration& red = real.scenarios.front();
  EXPECT_EQ(red.name, "R2-juggle-red");
  EXPECT_EQ(red.family, "R2");
  EXPECT_TRUE(red.isRecorded);
  ASSERT_TRUE(red.clip);
  EXPECT_NE(red.description.find("Tuned on: yes ("), std::string::npos) << red.description;
  EXPECT_NE(red.description.find("±3 px"), std::string::npos) << red.description;
  EXPECT_FALSE(red.clip()) << "the folder is there, but empty: an error, no skipped clip";
}

} // namespace
} // namespace dewpoint::tests
