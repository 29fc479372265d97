// SPDX-License-Identifier: GPL-3.0-or-later
// [[correction]] in the project file.
#include "core/base/text_file.h"
#include "core/project/project.h"
#include "core/project/project_changes.h"
#include "core/project/project_check.h"
#include "core/project/project_load.h"
#include "core/project/project_save.h"

#include <gtest/gtest.h>

#include <limits>

namespace dewpoint::tests {
namespace {

constexpr const char* kTwoTargets = R"(format = 2
method = "dewpoint"
[[target]]
name = "ball"
hue = [330, 20]
[[target]]
name = "cap"
hue = [100, 140]
[[camera]]
name = "left"
video = "left.mkv"
[camera.calibration]
size = [640, 480]
matrix = [[500.0, 0, 319.5], [0, 500.0, 239.5], [0, 0, 1]]
rotation = [0, 0.1, 0]
translation = [1.0, 2.0, 3.0]
[[camera]]
name = "right"
video = "right.mkv"
[camera.calibration]
size = [640, 480]
matrix = [[500.0, 0, 319.5], [0, 500.0, 239.5], [0, 0, 1]]
rotation = [0, -0.1, 0]
translation = [-1.0, 2.0, 3.0]
)";

constexpr const char* kHere = "[[correction]]\nframe = 12\ntarget = 2\nposition = [0.5, 2, -0.1]\n"
                              "covariance = [4e-4, 1e-5, 0, 9e-4, -2e-5, 1e-4]\n";

std::filesystem::path fileOfTest(const std::string& name) {
  // A name of its own per test: tests run side by side.
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::path(testing::TempDir()) / (std::string(info->name()) + "_" + name);
}

Result<Project> loaded(const std::string& corrections) {
  const auto file = fileOfTest("project.toml");
  EXPECT_TRUE(writeTextFile(file, kTwoTargets + corrections));
  return loadProject(file);
}

PositionCorrection correctionOf(std::int64_t frame, int target) {
  PositionCorrection correction;
  correction.frame = frame;
  correction.target = target;
  correction.covariance *= 1e-4;
  return correction;
}

TEST(ProjectCorrections, ComeBackInTheOrderOfTheirFrames) {
  EXPECT_TRUE(loaded("")->corrections.empty()); // as in every file before there was this
  const auto project = loaded("[[correction]]\nframe = 90\ntarget = 1\nposition = [1.5, 0, 0]\n"
                              "covariance = [1e-4, 0, 0, 1e-4, 0, 1e-4]\n" +
                              std::string(kHere) +
                              "[[correction.click]]\ncamera = 2\npixel = [20.5, 31]\n"
                              "[[correction.click]]\ncamera = 1\npixel = [700, -3.25]\n");
  ASSERT_TRUE(project) << errorSentence(project.error());
  ASSERT_EQ(project->corrections.size(), 2U);
  const PositionCorrection& first = project->corrections[0];
  EXPECT_EQ(first.frame, 12);
  EXPECT_EQ(first.target, 1);
  EXPECT_EQ(first.position, Eigen::Vector3d(0.5, 2.0, -0.1));
  EXPECT_EQ(first.covariance(0, 1), 1e-5);
  EXPECT_EQ(first.covariance(2, 1), -2e-5);
  EXPECT_EQ(first.covariance(2, 2), 1e-4);
  EXPECT_EQ(first.clicks, (std::vector<PointClick>{{1, {20.5, 31.0}}, {0, {700.0, -3.25}}}));
  EXPECT_EQ(project->corrections[1].frame, 90);
  EXPECT_TRUE(project->corrections[1].clicks.empty());
  const auto file = fileOfTest("again.toml");
  ASSERT_TRUE(saveProject(*project, file));
  const auto again = loadProject(file);
  ASSERT_TRUE(again) << errorSentence(again.error());
  EXPECT_EQ(again->corrections, project->corrections);
  Project other = *again;
  other.corrections.pop_back();
  EXPECT_TRUE(changesBetween(*again, other).correctionsChanged);
  EXPECT_TRUE(changesBetween(*again, other).hasAny());
}

TEST(ProjectCorrections, ThoseTrackedBackGoWithWhatTheyCameFrom) {
  const auto project = loaded(std::string(kHere) + "tracked_from = 40\n");
  ASSERT_TRUE(project) << errorSentence(project.error());
  EXPECT_EQ(project->corrections[0].trackedFrom, 40);
  const auto file = fileOfTest("again.toml");
  ASSERT_TRUE(saveProject(*project, file));
  EXPECT_EQ(loadProject(file)->corrections, project->corrections);
  EXPECT_EQ(loaded(std::string(kHere) + "tracked_from = 12\n").error().field,
            "correction 1.tracked_from");

  Project edited = *project;
  const auto backFrom = [](std::int64_t from, std::int64_t frame, int target) {
    PositionCorrection correction = correctionOf(frame, target);
    correction.trackedFrom = from;
    return correction;
  };
  const auto frames = [&] {
    std::vector<std::int64_t> all;
    for (const PositionCorrection& one : edited.corrections) {
      all.push_back(one.frame);
    }
    return all;
  };
  edited.corrections.clear();
  addCorrection(edited, correctionOf(40, 1));
  for (const std::int64_t frame : {10, 20, 30}) {
    addCorrection(edited, backFrom(40, frame, 1));
    addCorrection(edited, backFrom(50, frame, 0)); // of another target
  }
  EXPECT_EQ(frames(), (std::vector<std::int64_t>{10, 10, 20, 20, 30, 30, 40}));
  // Somebody says that it was elsewhere in between: what comes before was followed wrongly.
  addCorrection(edited, correctionOf(25, 1));
  EXPECT_EQ(frames(), (std::vector<std::int64_t>{10, 20, 25, 30, 30, 40}));
  // The correction itself is moved, or removed.
  addCorrection(edited, correctionOf(40, 1));
  EXPECT_EQ(frames(), (std::vector<std::int64_t>{10, 20, 25, 30, 40}));
  addCorrection(edited, backFrom(40, 35, 1));
  removeCorrection(edited, 40, 1);
  EXPECT_EQ(frames(), (std::vector<std::int64_t>{10, 20, 25, 30}));
}

TEST(ProjectCorrections, WhatCannotBeIsRefused) {
  const auto field = [](std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    const auto project = loaded(text);
    EXPECT_TRUE(project || !project.error().file.empty());
    return project ? std::string("none") : project.error().field;
  };
  const std::string clicked =
      kHere + std::string("[[correction.click]]\ncamera = 2\npixel = [20.5, 31]\n");
  EXPECT_EQ(field(clicked, "12", "13"), "none");
  EXPECT_EQ(field(kHere, "frame = 12\n", ""), "correction 1.frame");
  EXPECT_EQ(field(kHere, "12", "-1"), "correction 1.frame");
  EXPECT_EQ(field(kHere, "target = 2\n", ""), "correction 1.target");
  EXPECT_EQ(field(kHere, "target = 2", "target = 3"), "correction 1.target");
  EXPECT_EQ(field(kHere, "position = [0.5, 2, -0.1]\n", ""), "correction 1.position");
  EXPECT_EQ(field(kHere, "-0.1", "1e9"), "correction 1.position");
  EXPECT_EQ(field(kHere, "1e-5", "1"), "correction 1.covariance"); // a correlation above one
  EXPECT_EQ(field(kHere, "4e-4", "0"), "correction 1.covariance");
  EXPECT_EQ(field(kHere, "frame", "of = 1\nframe"), "correction 1.of");
  EXPECT_EQ(field(clicked, "camera = 2", "camera = 3"), "correction 1.click 1.camera");
  EXPECT_EQ(field(clicked, "camera = 2\n", ""), "correction 1.click 1.camera");
  EXPECT_EQ(field(clicked + "[[correction.click]]\ncamera = 2\npixel = [1, 1]\n", "12", "13"),
            "correction 1.click 2.camera");
  // Counted as in the file, not by their frames.
  std::string earlier = kHere;
  earlier.replace(earlier.find("12"), 2, "3");
  EXPECT_EQ(field(kHere + earlier, "frame = 3\ntarget = 2", "frame = 3\ntarget = 9"),
            "correction 2.target");
  EXPECT_NE(errorSentence(loaded(std::string(kHere) + "[[correction]]\nframe = 1\n").error())
                .find("project.toml"),
            std::string::npos);
}

TEST(ProjectCorrections, OfATargetAndFrameThereIsOne) {
  Project project;
  for (const auto& [frame, target] :
       {std::pair(9, 0), std::pair(3, 0), std::pair(9, 1), std::pair(5, 1)}) {
    addCorrection(project, correctionOf(frame, target));
  }
  PositionCorrection better = correctionOf(9, 0);
  better.position.x() = 1.0;
  addCorrection(project, better);
  EXPECT_EQ(project.corrections,
            (std::vector{correctionOf(3, 0), correctionOf(5, 1), better, correctionOf(9, 1)}));
}

TEST(ProjectCorrections, GoWithTheirTarget) {
  Project project = loaded("").value();
  project.corrections = {correctionOf(1, 1), correctionOf(2, 0), correctionOf(3, 1)};
  ASSERT_TRUE(checkProject(project));
  Project dangling = project;
  dangling.targets.pop_back();
  ASSERT_FALSE(checkProject(dangling));
  EXPECT_EQ(checkProject(dangling).error().field, "correction 1.target");
  removeTarget(project, 0);
  ASSERT_EQ(project.targets.size(), 1U);
  EXPECT_EQ(project.targets[0].name, "cap");
  EXPECT_EQ(project.corrections, (std::vector{correctionOf(1, 0), correctionOf(3, 0)}));
  EXPECT_TRUE(checkProject(project));
  project.corrections[0].position.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(checkProject(project).error().field, "correction 1.position");
}

} // namespace
} // namespace dewpoint::tests
