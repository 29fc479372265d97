// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/limits.h"
#include "core/base/toml_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace dewpoint::tests {
namespace {

std::string repeated(const std::string& part, std::size_t times) {
  std::string text;
  for (std::size_t k = 0; k < times; ++k) {
    text += part;
  }
  return text;
}

std::string problemOf(const std::string& text) {
  const auto table = base::parseToml(text, "a.toml");
  return table ? "" : base::errorSentence(table.error());
}

TEST(TomlText, NestedDeeperThanTheStackIsOneSentence) {
  const std::string sentence = "a.toml: line 2: invalid format (more than 64 levels "
                               "of keys, arrays and tables)";
  // 1,000,000 levels of tables, which are freed by recursion: 8 MiB of stack are not enough.
  EXPECT_EQ(problemOf("b = 1\n[a" + repeated(".a", 1'000'000) + "]\n"), sentence);
  EXPECT_EQ(problemOf("b = 1\na" + repeated(".a", 1'000'000) + " = 1\n"), sentence);
  EXPECT_EQ(problemOf("b = 1\n\"a\"" + repeated(" . 'a'", 100) + " = 1\n"), sentence);
  EXPECT_EQ(problemOf("b = 1\na = " + repeated("[", 100)), sentence);
  EXPECT_EQ(problemOf("b = 1\na = " + repeated("{a.a.a = ", 30)), sentence);
}

TEST(TomlText, OfMuchThatIsNotNestedIsRead) {
  EXPECT_EQ(problemOf("a = [" + repeated("1.0, 2.5, ", 1000) + "]"), "");
  EXPECT_EQ(problemOf("a = [\n" + repeated("[1.0, 2.5],\n", 1000) + "]"), "");
  EXPECT_EQ(problemOf("a = \"" + repeated("../", 1000) + "\" # " + repeated(".", 1000)), "");
  EXPECT_EQ(problemOf("a = '''\n" + repeated(".\n[", 1000) + "'''\nb = \"\\\"" + repeated("[", 99) +
                      "\""),
            "");
  EXPECT_EQ(problemOf(repeated("[[a]]\nb.c = {d = 1.5}\n", 1000)), "");
  EXPECT_EQ(problemOf("a = \"" + std::string(1'000'000, 'x') + "\""), "");
  EXPECT_EQ(problemOf("a = " + repeated("[", 60) + repeated("]", 60)), "");
}

TEST(TomlText, ThatIsNoneIsOneSentence) {
  for (const std::string& text :
       {std::string("a = \xFF"), std::string("a = 1\0", 6), std::string("a = \"\xED\xA0\x80\""),
        std::string("a ="), std::string("= 1"), std::string("\"\"\""), std::string("'"),
        std::string("a = \"\\"), std::string("[")}) {
    const std::string problem = problemOf(text);
    EXPECT_TRUE(problem.starts_with("a.toml: line 1: invalid format (")) << problem;
    EXPECT_EQ(problem.find('\n'), std::string::npos);
  }
}

TEST(TomlText, QuotesEveryCharacter) {
  std::string text;
  for (char letter = 1; letter < 127; ++letter) {
    text += letter;
  }
  text += "\x7F\xC3\xA4";
  const auto table = base::parseToml("a = " + base::tomlQuoted(text), "a.toml");
  ASSERT_TRUE(table) << base::errorSentence(table.error());
  EXPECT_EQ((*table)["a"].value<std::string>(), text);
  EXPECT_EQ(base::tomlQuoted("b\xFF\xC3\xA4\xC3"), "\"b?\xC3\xA4?\"");
}

} // namespace
} // namespace dewpoint::tests
