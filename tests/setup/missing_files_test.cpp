// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/calibration_file.h"
#include "core/project/project_load.h"
#include "core/setup/missing_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;
using Kind = MissingFile::Kind;

/// A folder of its own for each test.
class MissingFilesTest : public ::testing::Test {
protected:
  MissingFilesTest()
      : folder_(fs::temp_directory_path() /
                (std::string("dewpoint-missing-") +
                 ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~MissingFilesTest() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  fs::path write(const fs::path& name, const std::string& text = "some") const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  /// A project of two videos, for a method that needs no calibration.
  fs::path projectOf(const std::string& more = {}) const {
    return write("desk.toml", "format = 2\nmethod = \"histogram\"\n" + more + R"(
[[camera]]
name = "left"
video = "videos/left.mp4"
empty_room = "room.png"
[[camera]]
name = "right"
video = "videos/right.mp4"
)");
  }

  fs::path folder_;
};

TEST_F(MissingFilesTest, AreListedWithTheirCameras) {
  const fs::path project = projectOf("truth = \"truth.csv\"\ncalibration = \"rig.toml\"\n");
  write("videos/right.mp4");
  const auto missing = missingFilesOf(project);
  ASSERT_TRUE(missing.has_value());
  const std::vector<MissingFile> expected{
      {Kind::Video, 0, "left", folder_ / "videos/left.mp4"},
      {Kind::BackgroundImage, 0, "left", folder_ / "room.png"},
      {Kind::Calibration, -1, "", folder_ / "rig.toml"},
      {Kind::Truth, -1, "", folder_ / "truth.csv"},
  };
  EXPECT_EQ(*missing, expected);
}

TEST_F(MissingFilesTest, NothingIsMissing) {
  const fs::path project = projectOf();
  write("videos/left.mp4");
  write("videos/right.mp4");
  write("room.png");
  EXPECT_EQ(missingFilesOf(project).value(), std::vector<MissingFile>{});
  EXPECT_FALSE(missingFilesOf(folder_ / "no.toml").has_value());
}

TEST_F(MissingFilesTest, OneThatIsFoundLeadsToTheOthers) {
  const fs::path project = projectOf();
  const fs::path left = write("elsewhere/one.mp4"); // renamed
  const fs::path right = write("elsewhere/right.mp4");
  const auto missing = missingFilesOf(project);
  ASSERT_TRUE(missing.has_value());
  ASSERT_EQ(missing->size(), 3U);
  const MovedFiles moved = locateRemainingFiles(*missing, missing->front(), left);
  EXPECT_EQ(moved, (MovedFiles{{folder_ / "videos/left.mp4", left},
                               {folder_ / "videos/right.mp4", right}}));

  const auto still = missingFilesOf(project, moved);
  ASSERT_TRUE(still.has_value());
  ASSERT_EQ(still->size(), 1U);
  EXPECT_EQ(still->front().path, folder_ / "room.png");

  const auto loaded = loadProject(project, moved);
  ASSERT_TRUE(loaded.has_value()) << errorSentence(loaded.error());
  EXPECT_EQ(loaded->cameras[0].location, left.string());
  EXPECT_EQ(loaded->cameras[1].location, right.string());
}

TEST_F(MissingFilesTest, RecordingsOfOneNameAreToldApartByTheirFolders) {
  const std::vector<MissingFile> missing{
      {Kind::Video, 0, "a", folder_ / "old/a/video.mp4"},
      {Kind::Video, 1, "b", folder_ / "old/b/video.mp4"},
      {Kind::Video, 2, "c", folder_ / "old/c/video.mp4"},
  };
  const fs::path a = write("new/a/video.mp4");
  const fs::path b = write("new/b/video.mp4");
  EXPECT_EQ(locateRemainingFiles(missing, missing[0], a),
            (MovedFiles{{missing[0].path, a}, {missing[1].path, b}}));
}

TEST_F(MissingFilesTest, ACalibrationThatWasMovedIsReadWhereItIs) {
  const fs::path project = write("desk.toml", R"(
format = 2
calibration = "rig.toml"
[[camera]]
name = "left"
video = "left.mp4"
)");
  EXPECT_FALSE(loadProject(project).has_value());
  const auto missing = missingFilesOf(project);
  ASSERT_TRUE(missing.has_value());
  const fs::path rig = write("elsewhere/rig.toml");
  Camera left;
  left.name = "left";
  left.intrinsics.width = 640;
  left.intrinsics.height = 480;
  left.intrinsics.focalX = left.intrinsics.focalY = 500.0;
  ASSERT_TRUE(saveCalibration({left}, rig).has_value());
  const auto calibration = std::ranges::find(*missing, Kind::Calibration, &MissingFile::kind);
  ASSERT_NE(calibration, missing->end());
  const auto loaded = loadProject(project, locateRemainingFiles(*missing, *calibration, rig));
  ASSERT_TRUE(loaded.has_value()) << errorSentence(loaded.error());
  EXPECT_EQ(loaded->cameras[0].camera.intrinsics.width, 640);
}

TEST_F(MissingFilesTest, OfAProjectInNoFile) {
  Project project;
  project.cameras.resize(2);
  project.cameras[0].source = SourceKind::Images;
  project.cameras[0].location = (folder_ / "images").string();
  project.cameras[1].source = SourceKind::Device;
  project.cameras[1].location = "0";
  const auto missing = missingFilesOf(project);
  ASSERT_EQ(missing.size(), 1U);
  EXPECT_TRUE(missing[0].isFolder());
  const Project now = withMovedFiles(project, {{folder_ / "images", folder_ / "new"}});
  EXPECT_EQ(now.cameras[0].location, (folder_ / "new").string());
  EXPECT_EQ(now.cameras[1].location, "0");
}

} // namespace
} // namespace dewpoint::tests
