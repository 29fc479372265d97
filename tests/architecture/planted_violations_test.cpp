// SPDX-License-Identifier: GPL-3.0-or-later
// What the order of the rooms forbids is found, from each room.
#include "tests/architecture/namespace_rule.h"
#include "tests/architecture/planted_violations.h"
#include "tests/architecture/room_tables.h"
#include "tests/architecture/source_rules.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

/// The folders below core, ui and app of `root` that have sources, such as "core/base".
Names foldersWithSources(const fs::path& root) {
  Names found;
  for (const char* top : {"core", "ui", "app"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const std::string extension = entry.path().extension().string();
      const fs::path folder = fs::relative(entry.path().parent_path(), root);
      if (entry.is_regular_file() && (extension == ".h" || extension == ".cpp") &&
          folder.has_parent_path()) { // precompiled.h lies beside the rooms
        found.insert(folder.generic_string());
      }
    }
  }
  return found;
}

Names roomsOfTheTables() {
  Names found;
  for (const auto& [floor, below] : floorTable()) {
    const auto rooms = roomTable().find(floor);
    if (rooms == roomTable().end()) {
      found.insert("core/" + floor);
      continue;
    }
    for (const auto& [room, open] : rooms->second) {
      found.insert("core/" + floor + (room.empty() ? "" : "/") + room);
    }
  }
  for (const Names& floor : windowFloors()) {
    for (const std::string& room : floor) {
      found.insert("ui/" + room);
    }
  }
  for (const auto& [room, open] : commandTable()) {
    found.insert("app/dewpoint-cli/" + room);
  }
  for (const std::string& program : windowlessPrograms()) {
    found.insert("app/" + program);
  }
  return found;
}

Names roomsWithPlantedViolation() {
  Names found;
  for (const PlantedViolation& planted : plantedViolations()) {
    found.insert(fs::path(planted.file).parent_path().generic_string());
  }
  return found;
}

TEST(Architecture, WhatIsPlantedIsFound) {
  for (const auto& [file, include] : plantedViolations()) {
    const std::string text =
        "#include \"" + include + "\"\nnamespace " + namespaceOf(file) + " {}\n";
    EXPECT_EQ(violations(file, text).size(), 1U) << file << " includes " << include;
  }
}

TEST(Architecture, EachRoomHasAPlantedViolation) {
  const Names planted = roomsWithPlantedViolation();
  const Names folders = foldersWithSources(DEWPOINT_SOURCE_DIR);
  EXPECT_GT(folders.size(), 50U);
  for (const std::string& room : folders) {
    EXPECT_TRUE(planted.contains(room)) << room << " has sources";
  }
  for (const std::string& room : roomsOfTheTables()) {
    EXPECT_TRUE(planted.contains(room)) << room << " is in a table";
    EXPECT_TRUE(folders.contains(room)) << room << " is in a table and has no sources";
  }
  for (const std::string& room : planted) {
    EXPECT_TRUE(folders.contains(room)) << room << " has no sources";
  }
}

// The list is how much of core the window may know beside what core/session and core/setup hand
// out.
TEST(Architecture, TheWindowSeesNoMoreHeadersOfTheCore) {
  constexpr std::size_t kMost = 36;
  EXPECT_LE(windowHeaders().size(), kMost)
      << "let core/session or core/setup hand out what is needed, or take another header away";
  for (const std::string& header : windowHeaders()) {
    EXPECT_TRUE(fs::exists(fs::path(DEWPOINT_SOURCE_DIR) / header)) << header;
  }
}

} // namespace
} // namespace dewpoint::tests
