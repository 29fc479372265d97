// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_files.h"
#include "core/tracking/catalog/method_catalog.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

Project projectWithFiles() {
  Project project;
  project.file = "/lab/day/project.toml";
  project.parameters = ParameterValues(methodParameters("dewpoint"));
  ProjectCamera video;
  video.camera.name = "left";
  video.source = SourceKind::Video;
  video.location = "/lab/day/left.mkv";
  video.captureTimeFile = "/lab/day/left.csv";
  ProjectCamera images;
  images.camera.name = "right";
  images.source = SourceKind::Images;
  images.location = "/archive/right";
  images.backgroundImageFile = "/lab/day/empty.png";
  project.cameras = {video, images};
  return project;
}

TEST(ProjectFiles, AreThoseThatARunReads) {
  Project project = projectWithFiles();
  project.truthFile = "/lab/day/truth.csv";
  std::vector<std::string> names;
  for (const ProjectFile& file : runInputFiles(project)) {
    names.push_back(file.name);
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"left.mkv", "left.csv", "/archive/right", "empty.png"}));
  EXPECT_EQ(runInputFiles(project).front().path, "/lab/day/left.mkv");
  EXPECT_TRUE(isRepeatable(project));
  project.cameras.back().source = SourceKind::Device;
  EXPECT_FALSE(isRepeatable(project));
}

TEST(ProjectFiles, TextOfARunHasWhatItsResultDependsOn) {
  const Project project = projectWithFiles();
  const std::string text = runInputText(project);
  Project other = project;
  other.windowLayout = "docks";
  other.markers = {{3, "here"}};
  other.truthFile = "/lab/day/truth.csv";
  EXPECT_EQ(runInputText(other), text);
  other.seed = 2;
  EXPECT_NE(runInputText(other), text);
  other = project;
  other.cameras.front().camera.intrinsics.focalX += 1e-9;
  EXPECT_NE(runInputText(other), text);
  // The folder as a whole may lie somewhere else.
  other = project;
  other.file = "/mnt/day/project.toml";
  other.cameras.front().location = "/mnt/day/left.mkv";
  other.cameras.front().captureTimeFile = "/mnt/day/left.csv";
  other.cameras.back().backgroundImageFile = "/mnt/day/empty.png";
  EXPECT_EQ(runInputText(other), text);
}

TEST(ProjectFiles, ProjectNeedsNoFileOfItsOwn) {
  Project project;
  project.scene = "demo";
  EXPECT_TRUE(runInputFiles(project).empty());
  EXPECT_NE(runInputText(project).find("scene = \"demo\""), std::string::npos);
}

TEST(ProjectFiles, SettingsAreWhatDiffersFromTheDefaults) {
  Project project = projectWithFiles();
  EXPECT_EQ(nonDefaultSettings(project), "");
  project.parameters.markAllAsGiven(); // at their defaults
  EXPECT_EQ(nonDefaultSettings(project), "");
  ASSERT_TRUE(project.parameters.set("kld_error", 0.0));
  ASSERT_TRUE(project.parameters.set("particles", 200));
  EXPECT_EQ(nonDefaultSettings(project), "particles=200 kld_error=0");
  project.volumeOfInterest = WorldBox{{0, 0, 0}, {1, 2, 0.5}};
  EXPECT_EQ(nonDefaultSettings(project), "particles=200 kld_error=0 volume=0,0,0,1,2,0.5");
}

} // namespace
} // namespace dewpoint::tests
