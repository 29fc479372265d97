// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

const std::filesystem::path kRoot = DEWPOINT_SOURCE_DIR;

std::vector<std::string> linesOf(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::filesystem::path> filesIn(const char* folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(kRoot / folder)) {
    if (entry.is_regular_file()) {
      files.push_back(entry.path());
    }
  }
  return files;
}

/// Rows that no table has: neither a row before them, nor the line under a header behind them.
std::vector<std::string> tornRows(const std::vector<std::string>& lines) {
  const auto isRow = [&](std::size_t k) { return k < lines.size() && lines[k].starts_with("|"); };
  const auto isRule = [&](std::size_t k) { return isRow(k) && lines[k].starts_with("| ---"); };
  std::vector<std::string> torn;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const bool follows = k > 0 && isRow(k - 1);
    if (isRow(k) && !follows && !isRule(k + 1)) {
      torn.push_back(lines[k]);
    }
  }
  return torn;
}

TEST(Docs, RowsStandInTheirTables) {
  for (const auto& file : filesIn("docs")) {
    if (file.extension() == ".md") {
      for (const std::string& row : tornRows(linesOf(file))) {
        ADD_FAILURE() << file.filename() << ": " << row;
      }
    }
  }
  EXPECT_EQ(tornRows({"| a |", "| --- |", "| b |", "", "| c |", "text"}),
            std::vector<std::string>{"| c |"});
}

// CMake puts all programs into one folder.
TEST(Docs, ProgramsAreNamedWhereTheyLie) {
  const std::regex program("build/[a-z]+/([a-z]+)/[a-z_-]+(_bench|_test)?");
  for (const char* folder : {"docs", "script"}) {
    for (const auto& file : filesIn(folder)) {
      for (const std::string& line : linesOf(file)) {
        for (std::sregex_iterator it(line.begin(), line.end(), program), end; it != end; ++it) {
          EXPECT_EQ((*it)[1].str(), "bin") << file.filename() << ": " << it->str();
        }
      }
    }
  }
}

} // namespace
} // namespace dewpoint::tests
