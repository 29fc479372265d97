// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
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

/// The texts between pairs of backticks in a line.
std::vector<std::string> inlineCode(const std::string& line) {
  static const std::regex kCode("`([^`]+)`");
  std::vector<std::string> texts;
  for (std::sregex_iterator it(line.begin(), line.end(), kCode), end; it != end; ++it) {
    texts.push_back((*it)[1]);
  }
  return texts;
}

/// Files and folders of the sources that a line of a page names, or links to from `folder`.
std::vector<std::filesystem::path> namedFiles(const std::string& line,
                                              const std::filesystem::path& folder) {
  static const std::regex kSource("(^|[^\\w./])((app|bench|core|docs|script|tests|ui)/[\\w./-]*)");
  static const std::regex kLink("\\]\\(([^)#:]+)(#[^)]*)?\\)"); // no address of the net
  std::vector<std::filesystem::path> files;
  for (const std::string& code : inlineCode(line)) {
    for (std::sregex_iterator it(code.begin(), code.end(), kSource), end; it != end; ++it) {
      files.push_back(kRoot / (*it)[2].str());
    }
  }
  for (std::sregex_iterator it(line.begin(), line.end(), kLink), end; it != end; ++it) {
    files.push_back(folder / (*it)[1].str());
  }
  return files;
}

std::vector<std::filesystem::path> pages() {
  auto pages = filesIn("docs");
  std::erase_if(pages, [](const auto& file) { return file.extension() != ".md"; });
  pages.push_back(kRoot / "README.md");
  pages.push_back(kRoot / "docs/examples/README.md");
  return pages;
}

TEST(Docs, FilesThatAreNamedExist) {
  for (const auto& page : pages()) {
    for (const std::string& line : linesOf(page)) {
      for (const auto& file : namedFiles(line, page.parent_path())) {
        EXPECT_TRUE(std::filesystem::exists(file)) << page.filename() << ": " << file;
      }
    }
  }
  const auto planted = namedFiles("`core/base/x.h` and [there](y.md#z), [net](https://a.b/c)", "f");
  EXPECT_EQ(planted, (std::vector<std::filesystem::path>{kRoot / "core/base/x.h", "f/y.md"}));
}

// Pages name a source beside another one without its folder.
TEST(Docs, SourcesNamedWithoutTheirFolderExist) {
  std::set<std::string> names;
  for (const char* folder : {"app", "bench", "core", "tests", "ui"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kRoot / folder)) {
      names.insert(entry.path().filename().string());
    }
  }
  const std::regex source("[a-z0-9_]+\\.(h|cpp)");
  for (const auto& page : pages()) {
    for (const std::string& line : linesOf(page)) {
      for (const std::string& code : inlineCode(line)) {
        if (std::regex_match(code, source)) {
          EXPECT_TRUE(names.contains(code)) << page.filename() << ": " << code;
        }
      }
    }
  }
}

/// Programs of a build that a line names in another folder than `bin`; a script may have the
/// program's name in a variable.
std::vector<std::string> misplacedPrograms(const std::string& line) {
  static const std::regex kProgram("build/[a-z]+/([a-z]+)/[$a-z_-][{}a-z_-]*");
  std::vector<std::string> found;
  for (std::sregex_iterator it(line.begin(), line.end(), kProgram), end; it != end; ++it) {
    if ((*it)[1] != "bin") {
      found.push_back(it->str());
    }
  }
  return found;
}

// CMake puts all programs into one folder.
TEST(Docs, ProgramsAreNamedWhereTheyLie) {
  for (const char* folder : {"docs", "script"}) {
    for (const auto& file : filesIn(folder)) {
      for (const std::string& line : linesOf(file)) {
        for (const std::string& program : misplacedPrograms(line)) {
          ADD_FAILURE() << file.filename() << ": " << program;
        }
      }
    }
  }
  // As script/bench once had it.
  EXPECT_EQ(misplacedPrograms("  \"build/release/bench/$program\" \"$@\" 2>/dev/null"),
            std::vector<std::string>{"build/release/bench/$program"});
  EXPECT_EQ(misplacedPrograms("    build/release/bench/${program}"),
            std::vector<std::string>{"build/release/bench/${program}"});
  EXPECT_EQ(misplacedPrograms("build/dev/tests/dewpoint_base_test"),
            std::vector<std::string>{"build/dev/tests/dewpoint_base_test"});
  EXPECT_TRUE(misplacedPrograms("\"build/release/bin/$program\" build/release/bin/x").empty());
}

} // namespace
} // namespace dewpoint::tests
