// SPDX-License-Identifier: GPL-3.0-or-later
// The tree of tests mirrors that of core.
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

/// Folders of core with sources, below `root`, that have no folder of tests at the same place.
std::vector<std::string> foldersWithoutTests(const fs::path& root) {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(root / "core")) {
    if (!entry.is_directory() || !holds(entry.path(), ".cpp")) {
      continue;
    }
    const fs::path room = fs::relative(entry.path(), root / "core");
    if (!holds(root / "tests" / room, "_test.cpp")) {
      found.push_back(room.generic_string());
    }
  }
  return found;
}

TEST(Architecture, EachRoomOfTheCoreHasItsTestsAtTheSamePlace) {
  EXPECT_EQ(foldersWithoutTests(DEWPOINT_SOURCE_DIR), std::vector<std::string>());
}

TEST(SourceRules, FindsRoomsWithoutTests) {
  const fs::path root = fs::path(testing::TempDir()) / "mirror";
  fs::remove_all(root);
  for (const char* file :
       {"core/color/hsi.cpp", "core/color/likelihood/table.cpp", "core/base/only_a_header.h",
        "tests/color/hsi_test.cpp", "tests/color/likelihood/drawn.h"}) {
    fs::create_directories((root / file).parent_path());
    std::ofstream(root / file) << "\n";
  }
  EXPECT_EQ(foldersWithoutTests(root), std::vector<std::string>{"color/likelihood"});
}

} // namespace
} // namespace dewpoint::tests
