// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/source_rules.h"

#include "tests/architecture/namespace_rule.h"
#include "tests/architecture/quantity_rule.h"
#include "tests/architecture/room_tables.h"

#include <algorithm>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

namespace dewpoint::tests {
namespace {

std::vector<std::string> split(std::string_view path) {
  std::vector<std::string> parts;
  std::istringstream stream{std::string(path)};
  for (std::string part; std::getline(stream, part, '/');) {
    parts.push_back(part);
  }
  return parts;
}

/// The room of core/<floor>/<room>/<file>, which may be a room inside a room; "" for a file in the
/// floor's own folder.
std::string roomInCore(const std::vector<std::string>& parts) {
  std::string room;
  for (std::size_t part = 2; part + 1 < parts.size(); ++part) {
    room += (room.empty() ? "" : "/") + parts[part];
  }
  return room;
}

/// -1: no room of the window.
int windowFloor(const std::string& room) {
  for (std::size_t floor = 0; floor < windowFloors().size(); ++floor) {
    if (windowFloors()[floor].contains(room)) {
      return static_cast<int>(floor);
    }
  }
  return -1;
}

Names reachable(const std::string& floor) {
  Names found;
  std::vector<std::string> open = {floor};
  while (!open.empty()) {
    const std::string name = open.back();
    open.pop_back();
    if (found.insert(name).second) {
      for (const std::string& next : floorTable().at(name)) {
        open.push_back(next);
      }
    }
  }
  return found;
}

bool isQt(const std::string& include) {
  static const std::regex kQt("(Qt[A-Za-z0-9]*/.*)|(Q[A-Z][A-Za-z0-9]*)|(q[a-z0-9]+\\.h)");
  return std::regex_match(include, kQt);
}

bool isVtk(const std::string& include) {
  return include.rfind("vtk", 0) == 0;
}
bool isOpenCv(const std::string& include) {
  return include.rfind("opencv2", 0) == 0;
}
bool isOwn(const std::string& include) {
  static const std::regex kOwn("(core|ui|app|tests|bench)/.*");
  return std::regex_match(include, kOwn);
}

std::string coreArrow(const std::string& floor, const std::string& room,
                      const std::string& include) {
  const std::vector<std::string> target = split(include);
  if (target[0] != "core") {
    return "core stands below " + target[0];
  }
  const Names open = reachable(floor);
  const bool frameAllowed = open.contains("tracking") && include == kFrameHeader;
  const bool settingsAllowed = open.contains("project") && include == kDeviceSettingsHeader;
  if (target.size() < 3 || (!open.contains(target[1]) && !frameAllowed && !settingsAllowed)) {
    return "core/" + floor + " may not include core/" + (target.size() > 1 ? target[1] : "");
  }
  if (target[1] != floor || !roomTable().contains(floor)) {
    return {};
  }
  const std::string other = roomInCore(target);
  const auto& rooms = roomTable().at(floor);
  const bool known = rooms.contains(room) && rooms.contains(other);
  return known && (room == other || rooms.at(room).contains(other))
             ? ""
             : "room '" + room + "' of core/" + floor + " may not include room '" + other + "'";
}

std::string coreLibrary(const std::string& floor, const std::string& include) {
  if (isQt(include) || isVtk(include)) {
    return "core is complete without Qt and VTK";
  }
  if ((floor == "filter" || floor == "geometry") && isOpenCv(include)) {
    return "core/" + floor + " knows no images";
  }
  return {};
}

std::string windowArrow(const std::string& room, const std::string& inner,
                        const std::string& include) {
  const std::vector<std::string> target = split(include);
  if (target[0] == "core") {
    static const Names kOpen = {"session", "setup", "broadcast", "base"};
    return (target.size() > 2 && kOpen.contains(target[1])) || windowHeaders().contains(include)
               ? ""
               : "ui sees core/session, core/setup, core/broadcast and the value types they hand "
                 "out only";
  }
  if (target[0] != "ui") {
    return "ui stands below " + target[0];
  }
  const std::string other = target.size() > 2 ? target[1] : "";
  if (other == room) {
    const std::string otherInner = target.size() > 3 ? target[2] : "";
    return room != "calibration" || inner == otherInner || calibrationArrow(inner, otherInner)
               ? ""
               : "ui/calibration/" + inner + " may not include its neighbor " + otherInner;
  }
  return windowFloor(other) < windowFloor(room) || windowNeighbors(room, other)
             ? ""
             : "ui/" + room + " may not include ui/" + other;
}

std::string windowLibrary(const std::string& folder, const std::string& include) {
  if (folder == "scene3d" && isQt(include)) {
    return "ui/scene3d is free of Qt";
  }
  if (folder != "scene3d" && folder != "view3d" && isVtk(include)) {
    return "VTK stays in ui/scene3d and ui/view3d";
  }
  return {};
}

std::string commandArrow(const std::string& room, const std::string& include) {
  const std::vector<std::string> target = split(include);
  const std::string other = target.size() > 3 ? target[2] : "";
  if (room.empty() || other.empty() || target[0] != "app" || target[1] != "dewpoint-cli") {
    return {};
  }
  const auto row = commandTable().find(room);
  return row != commandTable().end() && (room == other || row->second.contains(other))
             ? ""
             : "app/dewpoint-cli/" + room + " may not include app/dewpoint-cli/" + other;
}

std::string appArrow(const std::string& folder, const std::string& room,
                     const std::string& include) {
  if (windowlessPrograms().contains(folder) &&
      (include.rfind("ui/", 0) == 0 || isQt(include) || isVtk(include))) {
    return "app/" + folder + " works without Qt and VTK";
  }
  const std::string top = split(include)[0];
  if (isOwn(include) && (top == "tests" || top == "bench")) {
    return "app stands below " + top;
  }
  return folder == "dewpoint-cli" ? commandArrow(room, include) : "";
}

/// Why a file in this folder (and room inside it) may not have this include; empty when it may.
std::string objection(const std::string& top, const std::string& folder, const std::string& room,
                      const std::string& include) {
  if (top == "core") {
    return isOwn(include) ? coreArrow(folder, room, include) : coreLibrary(folder, include);
  }
  if (top == "ui") {
    return isOwn(include) ? windowArrow(folder, room, include) : windowLibrary(folder, include);
  }
  return top == "app" ? appArrow(folder, room, include) : "";
}

/// core/<floor>/<file>, or core/<floor>/<room>/<file> on a floor that has rooms.
bool isPlaceInCore(const std::vector<std::string>& parts) {
  if (parts.size() < 3 || !floorTable().contains(parts[1])) {
    return false;
  }
  const std::string room = roomInCore(parts);
  const auto rooms = roomTable().find(parts[1]);
  return rooms == roomTable().end() ? room.empty() : rooms->second.contains(room);
}

} // namespace

std::vector<std::string> includesOf(std::string_view text) {
  static const std::regex kInclude("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"].*");
  std::vector<std::string> names;
  std::istringstream stream{std::string(text)};
  bool inComment = false;
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (!inComment && std::regex_match(line, match, kInclude)) {
      names.push_back(match[1]);
      continue;
    }
    const std::size_t open = line.rfind("/*");
    const std::size_t close = line.rfind("*/");
    if (close != std::string::npos && (open == std::string::npos || close > open)) {
      inComment = false;
    } else if (open != std::string::npos) {
      inComment = true;
    }
  }
  return names;
}

int kindQuestions(std::string_view text) {
  static const std::regex kKind("\\b(TargetSource|RunTableKind)::[A-Z]");
  static const std::regex kEstimate(
      "(\\.|->)(box|person)\\(\\)(?!\\s*->)"); // -> uses it, asks nothing
  static const std::regex kAbility("capability<\\w+>\\([^()]*\\)\\s*[!=]=\\s*nullptr");
  const auto count = [](const std::string& code, const std::regex& sought) {
    return static_cast<int>(
        std::distance(std::sregex_iterator(code.begin(), code.end(), sought), {}));
  };
  int questions = 0;
  bool isFirstCase = false; // of a switch
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) {
    const std::string code = line.substr(0, line.find("//"));
    if (code.find("capability<") != std::string::npos) {
      questions += count(code, kAbility);
    }
    if (code.find("box()") != std::string::npos || code.find("person()") != std::string::npos) {
      questions += count(code, kEstimate);
    }
    if (code.find("::") != std::string::npos) {
      const int named = count(code, kKind);
      const bool isCase = code.find("case ") != std::string::npos;
      questions += isCase ? std::min(named, isFirstCase ? 1 : 0) : named;
    }
    if (code.find_first_not_of(' ') != std::string::npos) {
      isFirstCase = code.find("switch (") != std::string::npos;
    }
  }
  return questions;
}

int occurrencesOf(std::string_view sought, std::string_view text) {
  int occurrences = 0;
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) {
    const std::string code = line.substr(0, line.find("//"));
    for (std::size_t at = code.find(sought); at != std::string::npos;
         at = code.find(sought, at + 1)) {
      ++occurrences;
    }
  }
  return occurrences;
}

std::set<std::string> classesDefinedIn(std::string_view text) {
  // A definition begins in the first column; what is called stands farther right.
  static const std::regex kMember(
      R"(^(?=\S)(?:[\w:<>,&*\[\] ]+[ *&])?([A-Z]\w*)(?:::[A-Z]\w*)*::~?[a-zA-Z]\w*\(.*)");
  std::set<std::string> names;
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (std::regex_match(line, match, kMember)) {
      names.insert(match[1]);
    }
  }
  return names;
}

std::vector<std::string> violations(const std::string& path, std::string_view text) {
  std::vector<std::string> found;
  const std::vector<std::string> parts = split(path);
  const auto lineCount = std::count(text.begin(), text.end(), '\n');
  if (lineCount > kLineLimit) {
    found.push_back(path + ": " + std::to_string(lineCount) + " lines, the limit is " +
                    std::to_string(kLineLimit));
  }
  const std::string folder = parts.size() > 2 ? parts[1] : "";
  const std::string room =
      parts[0] == "core" ? roomInCore(parts) : (parts.size() > 3 ? parts[2] : "");
  const bool precompiled = parts.size() == 2 && parts[1] == "precompiled.h";
  if (parts[0] == "core" && !precompiled && !isPlaceInCore(parts)) {
    found.push_back(path + ": not in a room of core");
    return found;
  }
  if (parts[0] == "ui" && !precompiled && windowFloor(folder) < 0) {
    found.push_back(path + ": not in a room of the window");
    return found;
  }
  for (const std::string& include : includesOf(text)) {
    const std::string reason = precompiled ? "" : objection(parts[0], folder, room, include);
    if (!reason.empty()) {
      found.push_back(path + " includes " + include + ": " + reason);
    }
  }
  if (!opensItsNamespace(path, text)) {
    found.push_back(path + " does not open its namespace " + namespaceOf(path));
  }
  for (const std::string& written : quantitiesByHand(path, text)) {
    found.push_back(path +
                    " writes a quantity by hand, see ui/text/quantity_text.h and "
                    "core/base/units.h: " +
                    written);
  }
  return found;
}

} // namespace dewpoint::tests
