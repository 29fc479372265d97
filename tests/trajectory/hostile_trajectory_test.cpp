// SPDX-License-Identifier: GPL-3.0-or-later
// Trajectories that ask for too much: each is one sentence, at once.
#include "core/trajectory/evaluation.h"
#include "core/trajectory/export/export_table.h"
#include "core/trajectory/trajectory_reader.h"
#include "tests/fuzz/hostile_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

namespace dewpoint::tests {
namespace {

class HostileTrajectory : public testing::Test {
protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    file_ = std::filesystem::path(testing::TempDir()) /
            (std::string("HostileTrajectory") + info->name() + ".csv");
  }
  void TearDown() override { std::filesystem::remove(file_); }

  Result<Trajectory> read(const std::string& text) {
    std::ofstream(file_, std::ios::binary) << text;
    return readTrajectory(file_);
  }
  std::string problemOf(const std::string& text) {
    const auto trajectory = read(text);
    const std::string sentence = trajectory ? "" : base::errorSentence(trajectory.error());
    return sentence.substr(std::min(sentence.size(), file_.string().size() + 2));
  }

  std::filesystem::path file_;
};

TEST_F(HostileTrajectory, OfWindowsIsTheSame) {
  const std::string text = corpusText("trajectory/all-columns.csv");
  const auto trajectory = read(text);
  const auto same = read(asOfWindows(text));
  ASSERT_TRUE(trajectory && same);
  EXPECT_EQ(same->samples.size(), 4U);
  EXPECT_EQ(same->samples.front().target, "a, b");
  EXPECT_EQ(same->header.cameras.size(), 1U);
  EXPECT_EQ(same->header.entries, trajectory->header.entries);
}

TEST_F(HostileTrajectory, ColumnsAndCommentsAreCounted) {
  EXPECT_EQ(problemOf("frame,x_m,y_m,z_m" + std::string(1'000'000, ',') + "\n"),
            "line 1: invalid format (more than 1000 cells)");
  EXPECT_EQ(problemOf("frame,x_m,y_m,z_m\n1,2,3,4" + std::string(1'000'000, ',') + "\n"),
            "line 2: invalid format (more than 1000 cells)");
  std::string comments;
  for (int k = 0; k <= 10'000; ++k) {
    comments += "#a:\n";
  }
  EXPECT_EQ(problemOf(comments + "frame,x_m,y_m,z_m\n"),
            "line 10001: invalid format (more than 10000 comments)");
}

TEST_F(HostileTrajectory, FramesAreThoseOfARecording) {
  for (const char* frame : {"9223372036854775807", "-9223372036854775808", "10000000001"}) {
    EXPECT_EQ(
        problemOf(fmt::format("frame,x_m,y_m,z_m\n{},1,2,3\n", frame)),
        fmt::format("line 2, frame: not a usable value (\"{}\" is not a valid number)", frame));
  }
  EXPECT_EQ(problemOf("frame,x_m,y_m,z_m\n1e400,1,2,3\n"),
            "line 2, frame: not a usable value (\"1e400\" is not a valid number)");
  EXPECT_EQ(problemOf("frame,x_m,y_m,z_m\n1,1e400,2,3\n"),
            "line 2, x_m: not a usable value (\"1e400\" is not a valid number)");
}

// A table of all targets by all times would have 10^8 cells, 24 GB, of a file of 200 kB.
TEST_F(HostileTrajectory, WithATargetPerRowMakesNoTable) {
  std::string text = "time_s,target,x_m,y_m,z_m\n";
  for (int k = 0; k < 10'000; ++k) {
    text += fmt::format("{0},t{0},1,2,3\n", k);
  }
  const auto trajectory = read(text);
  ASSERT_TRUE(trajectory);
  const auto table = makeExportTable(*trajectory, {}, {});
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error().field, "targets");
  EXPECT_EQ(table.error().detail, "10000 targets at 10000 times cannot be written in one table");
}

} // namespace
} // namespace dewpoint::tests
