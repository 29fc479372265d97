// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of docs/architecture.md list the same floors and rooms as those of the tests, and no
// table has a circle.
#include "tests/architecture/room_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <utility>

namespace dewpoint::tests {
namespace {

using Cells = std::vector<std::string>;
using Rooms = std::map<std::string, Names>;

std::vector<std::string> splitAt(const std::string& text, const std::string& mark) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(mark); end != std::string::npos; end = text.find(mark, begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + mark.size();
  }
  parts.push_back(text.substr(begin));
  return parts;
}

/// The rows below a header in docs/architecture.md.
std::vector<Cells> rowsBelow(const std::string& header) {
  std::ifstream page(std::filesystem::path(DEWPOINT_SOURCE_DIR) / "docs/architecture.md");
  std::string line;
  while (std::getline(page, line) && line != header) {
  }
  std::getline(page, line); // between header and rows
  std::vector<Cells> rows;
  while (std::getline(page, line) && line.starts_with("| ")) {
    rows.push_back(splitAt(line.substr(2, line.size() - 4), " | "));
  }
  return rows;
}

Names codeIn(const std::string& text) {
  static const std::regex kCode("`([^`]+)`");
  Names names;
  for (std::sregex_iterator it(text.begin(), text.end(), kCode), end; it != end; ++it) {
    names.insert((*it)[1]);
  }
  return names;
}

/// The room that an entry of a table is about, and the rooms after the arrow.
std::pair<std::string, Names> roomIn(const std::string& entry) {
  static const std::regex kEntry("(?:`([^`]+)`|own files)(?: ← ([^:]+))?(?:[: ].*)?");
  std::smatch match;
  if (!std::regex_match(entry, match, kEntry)) {
    ADD_FAILURE() << "no room: " << entry;
    return {};
  }
  Names open;
  if (match[2].matched) {
    const std::vector<std::string> names = splitAt(match[2], ", ");
    open.insert(names.begin(), names.end());
  }
  return {match[1].matched ? match[1].str() : "own files", open};
}

/// Adds the rooms of a row about the floor, or about the room `outer` of it, to those of the floor.
void addRooms(const std::string& outer, const std::string& cell, Rooms& rooms) {
  const auto inTheFloor = [&](const std::string& name) {
    return name == "own files" ? outer : outer.empty() ? name : outer + "/" + name;
  };
  for (const std::string& entry : splitAt(cell, "<br>")) {
    const auto [room, open] = roomIn(entry);
    Names& inTheTable = rooms[inTheFloor(room)];
    for (const std::string& name : open) {
      inTheTable.insert(inTheFloor(name));
    }
  }
}

/// What "all rooms" of a floor are.
void nameAllRooms(Rooms& rooms) {
  for (auto& [room, open] : rooms) {
    if (open.erase("all rooms") + open.erase("all other rooms") > 0) {
      for (const auto& [other, unused] : rooms) {
        open.insert(other);
      }
      open.erase(room);
    }
  }
}

std::map<std::string, Rooms> roomsOnThePage() {
  std::map<std::string, Rooms> floors;
  for (const Cells& row : rowsBelow("| floor | rooms, and what each may include |")) {
    const std::string place = *codeIn(row.at(0)).begin();
    const std::size_t slash = std::min(place.find('/'), place.size());
    const std::string outer = slash < place.size() ? place.substr(slash + 1) : "";
    addRooms(outer, row.at(1), floors[place.substr(0, slash)]);
  }
  for (auto& [floor, rooms] : floors) {
    nameAllRooms(rooms);
  }
  return floors;
}

TEST(ArchitecturePage, ListsTheFloors) {
  Names found;
  for (const Cells& row : rowsBelow("| folder | what it contains | may include |")) {
    const std::string folder = *codeIn(row.at(0)).begin();
    if (!folder.starts_with("core/")) {
      continue;
    }
    const std::string floor = folder.substr(5);
    found.insert(floor);
    ASSERT_TRUE(floorTable().contains(floor)) << floor;
    // Single headers of another floor are not in the table of the tests, and base is free for all.
    const auto below = splitAt(row.at(2).substr(0, row.at(2).find(", and the ")), ", ");
    Names onThePage(below.begin(), below.end());
    onThePage.erase("base");
    onThePage.erase("std");
    Names inTheTable = floorTable().at(floor);
    inTheTable.erase("base");
    EXPECT_EQ(onThePage, inTheTable) << floor;
  }
  EXPECT_EQ(found.size(), floorTable().size());
}

TEST(ArchitecturePage, ListsTheRoomsOfCore) {
  const auto page = roomsOnThePage();
  for (const auto& [floor, rooms] : roomTable()) {
    ASSERT_TRUE(page.contains(floor)) << floor;
    EXPECT_EQ(page.at(floor), rooms) << floor;
  }
  EXPECT_EQ(page.size(), roomTable().size());
}

TEST(ArchitecturePage, ListsTheRoomsOfTheWindow) {
  const auto rows = rowsBelow("| floor | rooms of `ui/` |");
  ASSERT_EQ(rows.size(), windowFloors().size());
  for (std::size_t k = 0; k < rows.size(); ++k) { // the uppermost floor is first
    const Names& floor = windowFloors()[rows.size() - 1 - k];
    EXPECT_TRUE(rows[k].at(0).starts_with(std::to_string(rows.size() - k))) << rows[k].at(0);
    Names found;
    for (const std::string& entry : splitAt(rows[k].at(1), "<br>")) {
      const auto [room, open] = roomIn(entry);
      found.insert(room);
      for (const std::string& other : floor) {
        EXPECT_EQ(open.contains(other), windowNeighbors(room, other)) << room << ", " << other;
      }
    }
    EXPECT_EQ(found, floor);
  }
}

TEST(ArchitecturePage, ListsTheRoomsOfCalibrationInTheWindow) {
  Names folders;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(DEWPOINT_SOURCE_DIR) / "ui/calibration")) {
    if (entry.is_directory()) {
      folders.insert(entry.path().filename().string());
    }
  }
  Names found;
  const std::string room = "`calibration` with ";
  for (const Cells& row : rowsBelow("| floor | rooms of `ui/` |")) {
    for (const std::string& entry : splitAt(row.at(1), "<br>")) {
      if (entry.starts_with(room)) {
        found = codeIn(entry.substr(room.size()));
      }
    }
  }
  EXPECT_EQ(found, folders);
}

TEST(ArchitecturePage, ListsTheFoldersOfThePrograms) {
  const auto rows = rowsBelow("| folder | what it contains | may include |");
  const auto app = std::ranges::find_if(rows, [](const Cells& row) { return row[0] == "`app/`"; });
  ASSERT_NE(app, rows.end());
  const Names named = codeIn(app->at(1));
  for (const auto& [room, open] : commandTable()) {
    EXPECT_TRUE(named.contains(room)) << room;
  }
  for (const std::string& program : windowlessPrograms()) {
    EXPECT_TRUE(named.contains(program)) << program;
  }
}

/// One of the rooms that include each other in a circle; empty if there is no circle.
std::string roomInACircle(Rooms rooms) {
  // Rooms that include nothing that is left are taken away, until none is left or all form circles.
  const auto isLowest = [&rooms](const auto& entry) {
    return std::ranges::none_of(entry.second,
                                [&](const std::string& name) { return rooms.contains(name); });
  };
  auto lowest = std::ranges::find_if(rooms, isLowest);
  while (lowest != rooms.end()) {
    rooms.erase(lowest);
    lowest = std::ranges::find_if(rooms, isLowest);
  }
  return rooms.empty() ? "" : "\"" + rooms.begin()->first + "\"";
}

TEST(RoomTables, HaveNoCircle) {
  EXPECT_EQ(roomInACircle({floorTable().begin(), floorTable().end()}), "");
  for (const auto& [floor, rooms] : roomTable()) {
    EXPECT_EQ(roomInACircle(rooms), "") << floor;
  }
  for (const Names& floor : windowFloors()) {
    Rooms rooms;
    for (const std::string& from : floor) {
      for (const std::string& to : floor) {
        if (windowNeighbors(from, to)) {
          rooms[from].insert(to);
        }
      }
    }
    EXPECT_EQ(roomInACircle(rooms), "") << *floor.begin();
  }
  EXPECT_EQ(roomInACircle({commandTable().begin(), commandTable().end()}), "");
}

TEST(SourceRules, FindsCirclesOfRooms) {
  EXPECT_EQ(roomInACircle({}), "");
  EXPECT_EQ(roomInACircle({{"", {"a", "b"}}, {"a", {"b"}}, {"b", {}}}), "");
  EXPECT_EQ(roomInACircle({{"a", {"b"}}, {"b", {"a"}}}), "\"a\"");
  EXPECT_EQ(roomInACircle({{"a", {"a"}}}), "\"a\"");
  EXPECT_EQ(roomInACircle({{"", {"c"}}, {"b", {}}, {"c", {"b", "d"}}, {"d", {""}}}), "\"\"");
}

TEST(SourceRules, ReadsRoomsFromThePage) {
  using Room = std::pair<std::string, Names>;
  EXPECT_EQ(roomIn("`board` ← bundle"), Room("board", {"bundle"}));
  EXPECT_EQ(roomIn("`a/b` ← own files, c: text, more: text"), Room("a/b", {"own files", "c"}));
  EXPECT_EQ(roomIn("own files: text ← here"), Room("own files", {}));
  EXPECT_EQ(roomIn("`a` with `b`, `c`. `b` includes `c`"), Room("a", {}));
  Rooms rooms;
  addRooms("a", "own files: text<br>`b` ← own files", rooms);
  addRooms("", "`a` ← c<br>`c`<br>`d` ← all other rooms", rooms);
  nameAllRooms(rooms);
  EXPECT_EQ(rooms, (Rooms{{"a", {"c"}}, {"a/b", {"a"}}, {"c", {}}, {"d", {"a", "a/b", "c"}}}));
}

} // namespace
} // namespace dewpoint::tests
