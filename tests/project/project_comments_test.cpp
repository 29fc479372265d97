// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"
#include "core/project/project.h"
#include "core/project/project_comments.h"
#include "core/project/project_load.h"
#include "core/project/project_save.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dewpoint::tests {
namespace {

constexpr const char* kByHand = R"(# Balls in the gym, March.
# Ask Ann before moving camera 1.

format = 1   # as the first Dewpoint wrote it
method = "barrera"
# what the file is called
name = "gym"

# Fewer were not enough.
[parameters]
particles = 500
# Found by trying:
motion_sigma = 0.02   # "m", not mm

# The red one. [[camera]] name = "no table"
[[target]]
name = "ball"   # inflated
radius = 0.035
hue = [330, 20]

# Stands on the shelf.

[[camera]]
name = "left"
video = "left.mkv"
# from the board, see notes
[camera.calibration]
size = [640, 480]
matrix = [
  [500.0, 0, 319.5],   # this goes
  [0, 510.0, 239.5],
  [0, 0, 1]]           # this stays
rotation = [0, 0.1, 0]
translation = [1.0, 2.0, 3.0]

# Hangs from the ceiling.
[[camera]]
name = "right"
video = "right.mkv"
[camera.calibration]
size = [640, 480]
matrix = [[500.0, 0, 319.5], [0, 510.0, 239.5], [0, 0, 1]]
rotation = [0, 0.2, 0]
translation = [1.0, 2.0, 3.0]

# The end.
)";

std::filesystem::path place(const char* name) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::path(testing::TempDir()) / (std::string(info->name()) + "_" + name);
}

/// The text of a file of these contents after it was loaded, changed and saved in place.
std::string saved(
    const std::string& contents, void (*change)(Project&) = [](Project&) {}) {
  const auto file = place("project.toml");
  EXPECT_TRUE(writeTextFile(file, contents));
  auto project = loadProject(file);
  EXPECT_TRUE(project) << (project ? "" : errorSentence(project.error()));
  if (project) {
    change(*project);
    EXPECT_TRUE(saveProject(*project, file));
  }
  EXPECT_TRUE(loadProject(file));
  return readTextFile(file).value_or("");
}

bool hasLines(const std::string& text, const std::string& lines) {
  return text.find(lines) != std::string::npos;
}

TEST(ProjectComments, StayWhereTheyStood) {
  const std::string text = saved(kByHand);
  EXPECT_TRUE(
      text.starts_with("# Balls in the gym, March.\n# Ask Ann before moving camera 1.\n\n"));
  EXPECT_TRUE(hasLines(text, "format = 2   # as the first Dewpoint wrote it\n"));
  EXPECT_TRUE(hasLines(text, "# what the file is called\nname = \"gym\"\n"));
  EXPECT_TRUE(hasLines(text, "\n\n# Fewer were not enough.\n[parameters]\n"));
  EXPECT_TRUE(hasLines(text, "# Found by trying:\nmotion_sigma = 0.02   # \"m\", not mm\n"));
  EXPECT_TRUE(hasLines(text, "\n\n# The red one. [[camera]] name = \"no table\"\n[[target]]\n"
                             "name = \"ball\"   # inflated\n"));
  EXPECT_TRUE(hasLines(text, "\n# Stands on the shelf.\n\n[[camera]]\nname = \"left\"\n"));
  EXPECT_TRUE(hasLines(text, "# from the board, see notes\n[camera.calibration]"));
  EXPECT_TRUE(hasLines(text, "# this stays\n"));
  EXPECT_FALSE(hasLines(text, "# this goes"));
  EXPECT_TRUE(hasLines(text, "# Hangs from the ceiling.\n[[camera]]\nname = \"right\"\n"));
  EXPECT_TRUE(text.ends_with("# The end.\n"));
}

TEST(ProjectComments, SavedTwiceTheyAreTheSameBytes) {
  const std::string once = saved(kByHand);
  EXPECT_EQ(saved(once), once);
}

TEST(ProjectComments, GoWithWhatIsCalledTheSame) {
  const std::string text = saved(kByHand, [](Project& project) {
    std::ranges::reverse(project.cameras);
    project.targets.clear();
    project.name = "hall";
  });
  EXPECT_TRUE(hasLines(text, "# Hangs from the ceiling.\n[[camera]]\nname = \"right\"\n"));
  EXPECT_TRUE(hasLines(text, "# Stands on the shelf.\n\n[[camera]]\nname = \"left\"\n"));
  EXPECT_FALSE(hasLines(text, "The red one")) << "its target is gone";
  EXPECT_TRUE(hasLines(text, "# what the file is called\nname = \"hall\"\n"));
}

TEST(ProjectComments, TheFirstLinesStayWhenTheirKeyGoes) {
  // The calibration of another file becomes the cameras' own: the key is not written any more.
  const std::string former = "# Mine.\ncalibration = \"c.toml\"\n# twice\nformat = 2\n";
  EXPECT_EQ(withComments("# Theirs.\nformat = 2\nname = \"x\"\n", former),
            "# Mine.\n# twice\n# Theirs.\nformat = 2\nname = \"x\"\n");
}

TEST(ProjectComments, NoneChangeNothing) {
  const std::string fresh = "# a\nformat = 2\n\n[[mark]]\nname = \"a # b\"   # c\n\n[[mark]]\n"
                            "name = \"a # b\"\ntext = '''\n# no comment\n'''\n";
  EXPECT_EQ(withComments(fresh, ""), fresh);
  EXPECT_EQ(withComments(fresh, "format = 2\r\n"), fresh);
  EXPECT_EQ(withComments(fresh, fresh), fresh);
  EXPECT_EQ(withComments(fresh, "[[mark]\nname = \"broken"), fresh);
}

TEST(ProjectComments, GoToAnotherFileWithTheProject) {
  const auto file = place("project.toml");
  ASSERT_TRUE(writeTextFile(file, kByHand));
  const auto project = loadProject(file);
  ASSERT_TRUE(project);
  ASSERT_TRUE(writeTextFile(place("other.toml"), "# of another project\nformat = 2\n"));
  ASSERT_TRUE(saveProject(*project, place("other.toml")));
  const std::string text = readTextFile(place("other.toml")).value_or("");
  EXPECT_TRUE(hasLines(text, "# Ask Ann"));
  EXPECT_FALSE(hasLines(text, "of another project"));
}

TEST(ProjectComments, ThoseOfEarlierVersionsAreInPresentSpelling) {
  const std::string text = saved("# Dewpoint project: metres, seconds, radians, pixels; Z is up\n"
                                 "# My own, in metres.\n"
                                 "format = 2\nname = \"x\"\nscene = \"demo\"\n");
  EXPECT_EQ(text.find("# Dewpoint project: metres"), std::string::npos);
  const auto head = text.find("# Dewpoint project: meters");
  EXPECT_NE(head, std::string::npos);
  EXPECT_EQ(text.find("# Dewpoint project:", head + 1), std::string::npos); // once
  EXPECT_NE(text.find("# My own, in metres."), std::string::npos);
}

} // namespace
} // namespace dewpoint::tests
