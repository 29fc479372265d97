// SPDX-License-Identifier: GPL-3.0-or-later
// The tree of tests mirrors those of core and of the window.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

bool holds(const fs::path& folder, std::string_view ending) {
  return fs::is_directory(folder) &&
         std::any_of(fs::directory_iterator(folder), fs::directory_iterator(),
                     [&](const fs::directory_entry& entry) {
                       return entry.path().filename().string().ends_with(ending);
                     });
}

/// Folders with sources below `sources` that have no folder of tests at the same place in `tests`;
/// both in `root`.
std::vector<std::string> foldersWithoutTests(const fs::path& root, const fs::path& sources,
                                             const fs::path& tests) {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(root / sources)) {
    if (!entry.is_directory() || !holds(entry.path(), ".cpp")) {
      continue;
    }
    const fs::path room = fs::relative(entry.path(), root / sources);
    if (!holds(root / tests / room, "_test.cpp")) {
      found.push_back(room.generic_string());
    }
  }
  return found;
}

TEST(Architecture, EachRoomHasItsTestsAtTheSamePlace) {
  const std::vector<std::string> none;
  EXPECT_EQ(foldersWithoutTests(DEWPOINT_SOURCE_DIR, "core", "tests"), none);
  EXPECT_EQ(foldersWithoutTests(DEWPOINT_SOURCE_DIR, "ui", "tests/ui"), none);
}

TEST(SourceRules, FindsRoomsWithoutTests) {
  const fs::path root = fs::path(testing::TempDir()) / "mirror";
  fs::remove_all(root);
  for (const char* file :
       {"core/color/hsi.cpp", "core/color/likelihood/table.cpp", "core/base/only_a_header.h",
        "tests/color/hsi_test.cpp", "tests/color/likelihood/drawn.h", "ui/plots/plot_stack.cpp",
        "ui/color/color_dock.cpp", "tests/ui/plots/plots_test.cpp"}) {
    fs::create_directories((root / file).parent_path());
    std::ofstream(root / file) << "\n";
  }
  EXPECT_EQ(foldersWithoutTests(root, "core", "tests"),
            std::vector<std::string>{"color/likelihood"});
  EXPECT_EQ(foldersWithoutTests(root, "ui", "tests/ui"), std::vector<std::string>{"color"});
}

} // namespace
} // namespace dewpoint::tests
