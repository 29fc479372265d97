// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of the documentation that script/figures writes, and of which state they are.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <ostream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace dewpoint::tests {

/// A table between `<!-- table: NAME -->` and `<!-- /table -->`, below a line that says what it is
/// of: "Commit `abc1234`; seeds 1 to 20; state `dewpoint` 1a2b3c4d, `barrera` 99aabbcc." or, where
/// it is not known to be of today's methods, "...; state older.", or, where no method has a part in
/// it or it holds times only, "...; state not compared."
struct TableState {
  std::string file;
  std::string name;
  std::string commit; ///< empty where the line is missing or wrong
  std::string seeds;
  bool older = false;
  bool compared = true;
  bool ended = false;                              ///< the end of the table is marked
  std::map<std::string, std::string> fingerprints; ///< by method
};

/// What a failing test calls it.
inline void PrintTo(const TableState& table, std::ostream* stream) {
  *stream << table.file << ": " << table.name;
}

/// Fills in what a line says; false when it says nothing of a state.
inline bool readState(const std::string& line, TableState& table) {
  static const std::regex kLine(
      "Commit `([0-9a-f]{7,40}(?:-dirty)?)`; seeds ([^;]+); state (.+)\\.");
  static const std::regex kMethod("`([a-z0-9-]+)` ([0-9a-f]{8})");
  static const std::regex kMethods("(?:`[a-z0-9-]+` [0-9a-f]{8}(?:, |$))+");
  std::smatch match;
  if (!std::regex_match(line, match, kLine)) {
    return false;
  }
  const std::string state = match[3];
  table.older = state == "older";
  table.compared = !table.older && state != "not compared";
  if (table.compared && !std::regex_match(state, kMethods)) {
    return false; // neither older nor of any state
  }
  for (std::sregex_iterator it(state.begin(), state.end(), kMethod), end; it != end; ++it) {
    table.fingerprints[(*it)[1]] = (*it)[2];
  }
  table.commit = match[1];
  table.seeds = match[2];
  return true;
}

/// All tables of a page, in their order.
inline std::vector<TableState> tableStates(const std::string& file, const std::string& page) {
  static const std::regex kBegin("<!-- table: ([a-z0-9-]+) -->");
  std::vector<TableState> tables;
  std::istringstream lines(page);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_match(line, match, kBegin)) {
      tables.push_back({file, match[1], {}, {}, false, true, false, {}});
      inside = true;
    } else if (inside && line == "<!-- /table -->") {
      tables.back().ended = true;
      inside = false;
    } else if (inside && tables.back().commit.empty()) {
      readState(line, tables.back());
    }
  }
  return tables;
}

/// What a page has to say, in a paragraph of its own, for tables of it to be of an older state.
inline constexpr const char* kNotMade =
    "Tables marked *state older* were made with earlier methods; `script/figures` updates them.";

/// Whether a page says so.
inline bool saysNotMade(const std::string& page) {
  return ("\n" + page).find(std::string("\n") + kNotMade + "\n") != std::string::npos;
}

/// The seeds that a line names: "1006001 to 1006020"; none for "none" and for all other words.
inline std::vector<std::uint64_t> namedSeeds(const std::string& words) {
  static const std::regex kSeeds("([0-9]{1,18})(?: to ([0-9]{1,18}))?");
  std::smatch match;
  std::vector<std::uint64_t> seeds;
  if (std::regex_match(words, match, kSeeds)) {
    seeds.push_back(std::stoull(match[1]));
    seeds.push_back(match[2].matched ? std::stoull(match[2]) : seeds.front());
  }
  return seeds;
}

/// What is wrong with a table, given the methods' states of today; nothing when all is well.
inline std::optional<std::string> staleness(const TableState& table,
                                            const std::map<std::string, std::string>& today) {
  for (const auto& [method, fingerprint] : table.fingerprints) {
    const auto now = today.find(method);
    if (now == today.end()) {
      return table.file + ": the table '" + table.name + "' is of method " + method +
             ", which does not exist any more: run script/figures";
    }
    if (now->second != fingerprint) {
      return table.file + ": the table '" + table.name + "' is of another state of method " +
             method + " (" + fingerprint + ", today's is " + now->second + "): run script/figures";
    }
  }
  return std::nullopt;
}

} // namespace dewpoint::tests
