// SPDX-License-Identifier: GPL-3.0-or-later
// What a run leaves in a folder.
#include "core/base/text_file.h"
#include "core/session/session.h"
#include "core/trajectory/trajectory_reader.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace dewpoint::tests {
namespace {

using test::inputs;
using test::reaches;

class SavedRun : public testing::Test {
protected:
  void SetUp() override {
    folder = std::filesystem::path(testing::TempDir()) /
             testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(folder);
  }
  nlohmann::json report() const {
    const auto text = readTextFile(folder / "run.json");
    return text ? nlohmann::json::parse(*text) : nlohmann::json();
  }
  std::filesystem::path folder;
};

TEST_F(SavedRun, CountsFramesIterationsAndTheirTimes) {
  Session session(inputs());
  session.play();
  ASSERT_TRUE(reaches(session, PlayState::Ended));
  ASSERT_TRUE(session.saveRun(folder / "made"));
  folder /= "made";
  const auto json = report();
  EXPECT_EQ(json["frames"], 12); // the fake recording's
  EXPECT_EQ(json["iterations"], 12);
  EXPECT_EQ(json["finished"], true);
  EXPECT_EQ(json["method"], "barrera");
  EXPECT_EQ(json["parameters"]["particles"], 100.0); // the project's
  const auto& times = json["milliseconds_per_frame"];
  EXPECT_GT(times["p50"], 0.0);
  EXPECT_LE(times["p50"], times["p99"]);
  EXPECT_LE(times["p99"], times["p99.9"]);
  EXPECT_LE(times["p99.9"], times["max"]);
  const auto trajectory = readTrajectory(folder / "trajectory.csv");
  ASSERT_TRUE(trajectory);
  EXPECT_EQ(trajectory->samples.size(), 12U);
}

TEST_F(SavedRun, TellsOfTheRunAfterTheRestart) {
  Session session(inputs());
  session.play();
  ASSERT_TRUE(reaches(session, PlayState::Ended));
  session.restart();
  session.stepFrame();
  ASSERT_TRUE(test::eventually([&] {
    const TrackSnapshotPtr now = session.newest();
    return now->iterationCount == 1 && now->state == PlayState::Paused;
  }));
  ASSERT_TRUE(session.saveRun(folder));
  EXPECT_EQ(report()["frames"], 1);
  EXPECT_EQ(report()["finished"], false);
}

TEST_F(SavedRun, AFolderThatIsAFileIsSaid) {
  std::ofstream(folder) << "here already";
  const Session session(inputs());
  const auto saved = session.saveRun(folder);
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().code, ErrorCode::FileUnwritable);
  EXPECT_NE(errorSentence(saved.error()).find(folder.filename().string()), std::string::npos);
}

} // namespace
} // namespace dewpoint::tests
