// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_load.h"
#include "core/project/project_save.h"
#include "tests/setup/doctor/examined_project.h"

namespace dewpoint::tests {
namespace {

using Doctor = ExaminedProject;

TEST_F(Doctor, AFileThatIsNoProject) {
  const std::string file = text("broken.toml", "format = 2\nname = \n");
  const auto project = loadProject(file);
  ASSERT_FALSE(project);
  const auto all = examineUnreadableProject(file, project.error());
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].kind, FindingKind::ProjectUnreadable);
  EXPECT_EQ(all[0].file, file);
}

TEST_F(Doctor, AProjectWithoutItsCalibrationFileNamesIt) {
  const std::string file = text("lost.toml", "format = 2\ncalibration = \"rig.toml\"\n"
                                             "[[camera]]\nname = \"a\"\nvideo = \"a.mp4\"\n");
  const auto project = loadProject(file);
  ASSERT_FALSE(project);
  const auto all = examineUnreadableProject(file, project.error());
  ASSERT_EQ(all.size(), 3U) << linesOf(all);
  EXPECT_EQ(all[1].placeholderValues[0], (folder_ / "a.mp4").string());
  EXPECT_EQ(all[1].field, "camera 1");
  EXPECT_EQ(all[2].placeholderValues[0], (folder_ / "rig.toml").string());
}

TEST_F(Doctor, RoomForResultsIsLookedForWhereTheFolderWillBe) {
  options_.outputFolder = folder_ / "not" / "yet";
  const auto all = findings();
  EXPECT_EQ(all.back().file, folder_.string());
}

} // namespace
} // namespace dewpoint::tests
