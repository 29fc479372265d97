// SPDX-License-Identifier: GPL-3.0-or-later
// Every option of the command line that a message advises exists.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<fs::path> sourcesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(DEWPOINT_SOURCE_DIR) / folder)) {
    if (entry.path().extension() == ".cpp") {
      files.push_back(entry.path());
    }
  }
  return files;
}

/// The options that the commands declare, and those that CLI11 adds itself.
std::set<std::string> declaredOptions() {
  static const std::regex kDeclaration(
      R"re(add_(?:option|flag)(?:_function)?\s*(?:<[^;(]*>)?\(\s*"([^"]*)")re");
  static const std::regex kOption("--[a-z][a-z0-9-]*");
  std::set<std::string> options{"--help", "--version"};
  for (const fs::path& file : sourcesIn("app/dewpoint-cli")) {
    const std::string text = contentOf(file);
    for (std::sregex_iterator at(text.begin(), text.end(), kDeclaration), end; at != end; ++at) {
      const std::string names = (*at)[1];
      for (std::sregex_iterator name(names.begin(), names.end(), kOption); name != end; ++name) {
        options.insert(name->str());
      }
    }
  }
  return options;
}

/// The options that the texts of a source name.
std::vector<std::string> advisedOptions(const std::string& source) {
  static const std::regex kLiteral(R"re("(?:\\.|[^"\\\n])*")re");
  static const std::regex kOption("(^|[^A-Za-z0-9_-])(--[a-z][a-z0-9-]*[a-z0-9])");
  std::vector<std::string> options;
  for (std::sregex_iterator at(source.begin(), source.end(), kLiteral), end; at != end; ++at) {
    const std::string text = at->str();
    for (std::sregex_iterator name(text.begin(), text.end(), kOption); name != end; ++name) {
      options.push_back((*name)[2]);
    }
  }
  return options;
}

TEST(AdviceOptions, AreFoundInTexts) {
  const std::string source = R"re(fail("use --board x; or (--frames A:B)", k--, "a--b"))re";
  EXPECT_EQ(advisedOptions(source), (std::vector<std::string>{"--board", "--frames"}));
}

TEST(AdviceOptions, EveryAdvisedOptionExists) {
  const auto declared = declaredOptions();
  ASSERT_GT(declared.size(), 50U);
  ASSERT_TRUE(declared.contains("--frames"));
  for (const char* folder : {"core", "app/dewpoint-cli", "ui"}) {
    for (const fs::path& file : sourcesIn(folder)) {
      if (file.filename() == "live_page.cpp") {
        continue; // variables of a style sheet
      }
      for (const std::string& option : advisedOptions(contentOf(file))) {
        EXPECT_TRUE(declared.contains(option)) << file << ": " << option;
      }
    }
  }
}

} // namespace
} // namespace dewpoint::tests
