// SPDX-License-Identifier: GPL-3.0-or-later
// A live run is recorded while it tracks, and tracked again from the take.
#include "core/capture/gstreamer/open_live.h"
#include "core/session/session.h"
#include "core/session/take/take_recorder.h"
#include "core/session/take/take_replay.h"
#include "tests/capture/temporary_folder.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace dewpoint::tests {
namespace {

/// The two-camera project with test patterns in place of its cameras.
Project patternProject(const std::string& encoding) {
  Project project = test::twoCameraProject();
  for (ProjectCamera& camera : project.cameras) {
    camera.source = SourceKind::Stream;
    camera.location = "test:ball?width=160&height=120&encoding=" + encoding;
  }
  return project;
}

/// A live run of test patterns, and its take.
class TakeReplayTest : public testing::Test {
protected:
  void open(const Project& project) {
    project_ = project;
    std::vector<LiveCamera> cameras;
    for (const ProjectCamera& camera : project.cameras) {
      LiveCamera live;
      live.name = camera.camera.name;
      live.location = camera.location;
      cameras.push_back(live);
      feeds_.push_back(std::make_shared<EncodedFeed>());
    }
    SessionInputs inputs;
    inputs.project = project;
    auto source = openLive(cameras, feeds_);
    ASSERT_TRUE(source) << errorSentence(source.error());
    inputs.source = std::move(*source);
    session_ = std::make_unique<Session>(std::move(inputs));
    session_->play();
    ASSERT_TRUE(test::eventually([&] { return session_->newest()->frame >= 0; }));
  }

  void record() {
    auto take = TakeRecorder::start(project_, feeds_, folder_ / "takes", {});
    ASSERT_TRUE(take) << errorSentence(take.error());
    take_ = std::move(*take);
    ASSERT_TRUE(test::eventually([&] {
      const TakeStatus status = take_->status();
      return status.cameras[0].counts.imageCount >= 5 && status.cameras[1].counts.imageCount >= 5;
    }));
  }

  /// Tracks so many further samples.
  void track(std::size_t samples) {
    const std::size_t wanted = session_->trajectory().samples.size() + samples;
    ASSERT_TRUE(test::eventually([&] { return session_->trajectory().samples.size() >= wanted; }));
  }

  void restart() {
    session_->restart(7);
    ASSERT_TRUE(test::eventually([&] { return session_->newest()->seed == 7; }));
  }

  /// Ends the run and the take, and compares them.
  ReplayComparison compare() {
    session_->pause();
    EXPECT_TRUE(test::reaches(*session_, PlayState::Paused));
    LiveRun live;
    RunRecord record = session_->record();
    live.report = runReport(record.project, record.statistics);
    live.project = record.project;
    live.trajectory = record.people.trajectory;
    live.frameRecords = session_->liveFrameRecords();
    live.framesWithOtherSettings = session_->oldResults().frameRanges;
    EXPECT_TRUE(take_->stop());
    const Status added = take_->addLiveRun(live);
    EXPECT_TRUE(added) << errorSentence(added.error());
    const auto compared =
        compareReplay(take_->status().folder, 1, [](std::int64_t, std::int64_t) { return true; });
    EXPECT_TRUE(compared) << errorSentence(compared.error());
    return compared.value_or(ReplayComparison());
  }

  test::TemporaryFolder folder_;
  Project project_;
  std::vector<EncodedFeedPtr> feeds_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<TakeRecorder> take_;
};

std::string allSentences(const ReplayComparison& comparison) {
  std::string text;
  for (const std::string& line : describeReplay(comparison)) {
    text += line + '\n';
  }
  return text;
}

TEST_F(TakeReplayTest, ARunThatBeganInTheTakeIsTheSameToTheLastBit) {
  open(patternProject("mjpeg"));
  record();
  restart();
  track(30);
  const ReplayComparison comparison = compare();
  EXPECT_TRUE(comparison.isBitIdentical()) << allSentences(comparison);
  EXPECT_GE(comparison.comparedFrameCount, 30);
  EXPECT_EQ(comparison.incompleteFrameCount, 0);
  EXPECT_EQ(comparison.largestPositionDifference, 0.0);
  EXPECT_TRUE(comparison.changedCameras.empty());
  EXPECT_NE(allSentences(comparison).find("Same in all"), std::string::npos);
}

TEST_F(TakeReplayTest, ARunThatBeganEarlierCannotBeCompared) {
  open(patternProject("mjpeg"));
  track(5);
  record();
  track(10);
  const ReplayComparison comparison = compare();
  EXPECT_GE(comparison.frameCountBeforeTake, 5);
  EXPECT_EQ(comparison.comparedFrameCount, 0);
  EXPECT_FALSE(comparison.isBitIdentical());
  EXPECT_NE(allSentences(comparison).find("before the take"), std::string::npos);
}

TEST_F(TakeReplayTest, OtherSettingsAndChangedImagesAreReported) {
  open(patternProject("raw")); // stored as JPEG
  record();
  restart();
  track(10);
  ParameterValues other = project_.parameters;
  ASSERT_TRUE(other.set("particles", 150));
  session_->setParameters(other);
  ASSERT_TRUE(test::eventually([&] { return !session_->oldResults().frameRanges.empty(); }));
  track(10);
  const ReplayComparison comparison = compare();
  EXPECT_FALSE(comparison.isBitIdentical());
  EXPECT_FALSE(comparison.framesWithOtherSettings.empty());
  EXPECT_EQ(comparison.changedCameras, (std::vector<std::string>{"left", "right"}));
  EXPECT_NE(allSentences(comparison).find("other settings"), std::string::npos);
}

TEST_F(TakeReplayTest, NotesOfAnotherFormAreAnError) {
  const std::filesystem::path take = folder_ / "notes";
  std::filesystem::create_directories(take / "live");
  std::ofstream(take / "live" / "frames.csv") << "";
  const auto errorOf = [&](const char* notes, const char* live) {
    std::ofstream(take / "take.json") << notes;
    std::ofstream(take / "live" / "live.json") << live;
    const auto compared = compareReplay(take, 1, [](std::int64_t, std::int64_t) { return true; });
    EXPECT_FALSE(compared);
    return compared ? Error{} : compared.error();
  };
  constexpr const char* kNotes = R"({"cameras": [{"name": "left", "images_changed": true}]})";
  constexpr const char* kLive = R"({"other_settings": [[0, 10]]})";
  EXPECT_EQ(errorOf(kNotes, kLive).code, ErrorCode::FileMissing) << "the project";
  for (const char* broken :
       {R"({"cameras": [1]})", R"({"cameras": [{"name": "left", "images_changed": "yes"}]})",
        R"({"cameras": [{"name": 5, "images_changed": true}]})"}) {
    const Error error = errorOf(broken, kLive);
    EXPECT_EQ(error.code, ErrorCode::NotParsed) << broken;
    EXPECT_EQ(error.field, "cameras 1") << broken;
  }
  for (const char* broken :
       {R"({"other_settings": [[0, 10], [0, 1e300]]})", R"({"other_settings": [[0, 10], [-1, 2]]})",
        R"({"other_settings": [[0, 10], 3]})"}) {
    const Error error = errorOf(kNotes, broken);
    EXPECT_EQ(error.code, ErrorCode::NotParsed) << broken;
    EXPECT_EQ(error.field, "other_settings 2") << broken;
  }
}

TEST_F(TakeReplayTest, ATakeWithoutARunHasNothingToCompare) {
  const auto compared =
      compareReplay(folder_ / "none", 1, [](std::int64_t, std::int64_t) { return true; });
  ASSERT_FALSE(compared);
  EXPECT_EQ(compared.error().code, ErrorCode::NotFound);
  EXPECT_FALSE(hasLiveRun(folder_ / "none"));
}

} // namespace
} // namespace dewpoint::tests
