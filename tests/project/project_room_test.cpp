// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"
#include "core/project/project.h"
#include "core/project/project_changes.h"
#include "core/project/project_load.h"
#include "core/project/project_save.h"
#include "tests/project/loaded_text.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

constexpr const char* kRoom = R"(format = 2
name = "room"

[[camera]]
name = "left"
video = "left.mkv"
rotate = 90
mirror = true
crop = [8, 0, 16, 4]
late_by = 0.012
times = "times.csv"
[camera.calibration]
size = [640, 480]
matrix = [[500.0, 0, 319.5], [0, 510.0, 239.5], [0, 0, 1]]
rotation = [0, 0.1, 0]
translation = [1.0, 2.0, 3.0]

[grid]
kind = "box"
size = [3.5, 2, 2.4]
step = 0.25
origin = [0.1, -0.2, 0.3]
turn = 0.5

[[point]]
name = "corner of the table"
world = [0.5, 0.25, 0.74]
[[point.click]]
camera = 1
pixel = [320.25, 120.5]
frame = 7

[[point]]
name = "door"
world = [2, 0, 0]
)";

std::string fieldOf(const std::string& from, const std::string& to) {
  const auto project = load(kRoom, from, to);
  EXPECT_FALSE(project) << from << " -> " << to;
  return project ? "" : project.error().field;
}

TEST(ProjectRoom, ReadsGridPointsAndMirror) {
  const auto project = load(kRoom);
  ASSERT_TRUE(project) << errorSentence(project.error());
  ASSERT_TRUE(project->grid);
  EXPECT_EQ(*project->grid,
            (ReferenceGrid{GridKind::Box, {3.5, 2.0, 2.4}, 0.25, {0.1, -0.2, 0.3}, 0.5}));
  ASSERT_EQ(project->measuredPoints.size(), 2U);
  EXPECT_EQ(project->measuredPoints[0].world, Eigen::Vector3d(0.5, 0.25, 0.74));
  ASSERT_EQ(project->measuredPoints[0].clicks.size(), 1U);
  EXPECT_EQ(project->measuredPoints[0].clicks[0].camera, 0);
  EXPECT_EQ(project->measuredPoints[0].clicks[0].pixel, Eigen::Vector2d(320.25, 120.5));
  EXPECT_EQ(project->measuredPoints[0].clicks[0].frame, 7);
  EXPECT_FALSE(load(kRoom, "frame = 7\n", "")->measuredPoints[0].clicks[0].frame); // of older files
  EXPECT_TRUE(project->measuredPoints[1].clicks.empty());
  EXPECT_TRUE(project->cameras[0].isMirrored);
  EXPECT_EQ(project->cameras[0].crop, (ImageMargins{8, 0, 16, 4}));
  EXPECT_EQ(project->cameras[0].delay, 0.012);
  EXPECT_EQ(std::filesystem::path(project->cameras[0].captureTimeFile).filename(), "times.csv");
}

constexpr const char* kVolume = "\n[volume_of_interest]\nmin = [-1, 0.5, 0]\nmax = [2, 3, 2.25]\n";

TEST(ProjectRoom, KeepsTheVolumeOfInterest) {
  EXPECT_FALSE(load(kRoom)->volumeOfInterest); // as in every file before there was this
  const WorldBox expected{{-1.0, 0.5, 0.0}, {2.0, 3.0, 2.25}};
  const auto project = load(std::string(kRoom) + kVolume);
  ASSERT_TRUE(project) << errorSentence(project.error());
  EXPECT_EQ(project->volumeOfInterest, expected);
  const auto again = load(projectText(*project, project->file.parent_path()));
  ASSERT_TRUE(again) << errorSentence(again.error());
  EXPECT_EQ(again->volumeOfInterest, expected);
  const auto inOneLine = load(kRoom, "name = \"room\"",
                              "volume_of_interest = { min = [-1, 0.5, 0], max = [2, 3, 2.25] }");
  ASSERT_TRUE(inOneLine) << errorSentence(inOneLine.error());
  EXPECT_EQ(inOneLine->volumeOfInterest, expected);
  Project without = *project;
  without.volumeOfInterest.reset();
  EXPECT_TRUE(changesBetween(without, *project).volumeChanged);
  EXPECT_TRUE(changesBetween(without, *project).hasAny());
  EXPECT_EQ(projectText(without, "").find("volume_of_interest"), std::string::npos);
}

TEST(ProjectRoom, RefusesAVolumeOfInterestThatIsNone) {
  const auto errorOf = [](std::string from, std::string to) {
    std::string text = kVolume;
    text.replace(text.find(from), from.size(), to);
    const auto project = load(kRoom + text);
    return project ? Error{} : project.error();
  };
  EXPECT_EQ(errorOf("max = [2, 3, 2.25]", "").field, "volume_of_interest.max");
  EXPECT_EQ(errorOf("min = [-1, 0.5, 0]", "min = [-1, 0.5]").field, "volume_of_interest.min");
  EXPECT_EQ(errorOf("min =", "low =").field, "volume_of_interest.low");
  EXPECT_EQ(errorOf("2.25", "1e9").field, "volume_of_interest.max");
  const Error empty = errorOf("[2, 3, 2.25]", "[2, 0.5, 2.25]");
  EXPECT_EQ(empty.field, "volume_of_interest.max");
  EXPECT_NE(empty.file.find("project.toml"), std::string::npos);
  EXPECT_EQ(empty.detail, "along y it begins at 0.5 m and ends at 0.5 m");
}

TEST(ProjectRoom, SavesWhatItRead) {
  const auto project = load(kRoom);
  ASSERT_TRUE(project);
  const auto again = load(projectText(*project, project->file.parent_path()));
  ASSERT_TRUE(again) << errorSentence(again.error());
  Project same = *again;
  same.file = project->file;
  EXPECT_EQ(same, *project);
}

TEST(ProjectRoom, WithoutThemAFileIsAsBefore) {
  auto project = load(kRoom);
  ASSERT_TRUE(project);
  project->grid.reset();
  project->measuredPoints.clear();
  project->cameras[0].isMirrored = false;
  project->cameras[0].crop = {};
  project->cameras[0].delay = 0.0;
  project->cameras[0].captureTimeFile.clear();
  const std::string text = projectText(*project, {});
  EXPECT_EQ(text.find("[grid"), std::string::npos);
  EXPECT_EQ(text.find("[[point"), std::string::npos);
  EXPECT_EQ(text.find("mirror"), std::string::npos);
  EXPECT_EQ(text.find("crop"), std::string::npos);
  EXPECT_EQ(text.find("late_by"), std::string::npos);
  EXPECT_EQ(text.find("times"), std::string::npos);
}

TEST(ProjectRoom, NamesWhatIsWrong) {
  EXPECT_EQ(fieldOf("\"box\"", "\"ceiling\""), "grid.kind");
  EXPECT_EQ(fieldOf("step = 0.25", "step = 0"), "grid.step");
  EXPECT_EQ(fieldOf("[3.5, 2, 2.4]", "[3.5, 0, 2.4]"), "grid.size");
  EXPECT_EQ(fieldOf("camera = 1", "camera = 2"), "point 1.click");
  EXPECT_EQ(fieldOf("\"door\"", "\"corner of the table\""), "point 2.name");
  EXPECT_EQ(fieldOf("\"door\"", "\"\""), "point 2.name");
  EXPECT_EQ(fieldOf("world = [2, 0, 0]", ""), "point 2.world");
  EXPECT_EQ(fieldOf("pixel = [320.25, 120.5]", ""), "point 1.click 1.pixel");
  EXPECT_EQ(fieldOf("frame = 7", "frame = -1"), "point 1.click 1.frame");
  EXPECT_EQ(fieldOf("turn = 0.5", "turns = 0.5"), "grid.turns");
  EXPECT_EQ(fieldOf("[8, 0, 16, 4]", "[8, 0, 16]"), "camera 1.crop");
  EXPECT_EQ(fieldOf("[8, 0, 16, 4]", "[8, 0, 16, -4]"), "camera 1.crop");
  EXPECT_EQ(fieldOf("[8, 0, 16, 4]", "[8.5, 0, 16, 4]"), "camera 1.crop");
  EXPECT_EQ(fieldOf("late_by = 0.012", "late_by = 3601"), "camera 1.late_by");
}

TEST(ProjectRoom, ChangesAreToldApart) {
  const auto project = load(kRoom);
  ASSERT_TRUE(project);
  Project other = *project;
  other.grid->step = 0.5;
  EXPECT_TRUE(changesBetween(*project, other).gridChanged);
  EXPECT_FALSE(changesBetween(*project, other).calibrationChanged);
  other = *project;
  other.measuredPoints[0].clicks[0].pixel.x() += 1.0;
  EXPECT_TRUE(changesBetween(*project, other).pointsChanged);
  EXPECT_TRUE(changesBetween(*project, other).hasAny());
  other = *project;
  other.cameras[0].isMirrored = false;
  EXPECT_TRUE(changesBetween(*project, other).sourcesChanged);
  other = *project;
  other.cameras[0].delay = 0.0;
  EXPECT_TRUE(changesBetween(*project, other).sourcesChanged);
  other = *project;
  other.cameras[0].captureTimeFile.clear();
  EXPECT_TRUE(changesBetween(*project, other).sourcesChanged);
}

TEST(ProjectRoom, ASceneCanHaveAnotherCalibration) {
  const std::string text = "format = 2\nscene = \"demo\"\n\n[[camera]]\nname = \"camera 2\"\n"
                           "[camera.calibration]\nsize = [320, 240]\n"
                           "matrix = [[400, 0, 159.5], [0, 400, 119.5], [0, 0, 1]]\n"
                           "rotation = [0, 0, 0]\ntranslation = [0, 0, 1]\n";
  const auto project = load(text);
  ASSERT_TRUE(project) << errorSentence(project.error());
  ASSERT_EQ(project->cameras.size(), 1U);
  EXPECT_TRUE(project->cameras[0].hasOwnCalibration);
  EXPECT_EQ(project->cameras[0].source, SourceKind::Simulation);
  const auto again = load(projectText(*project, {}));
  ASSERT_TRUE(again) << errorSentence(again.error());
  EXPECT_EQ(again->cameras, project->cameras);
}

} // namespace
} // namespace dewpoint::tests
