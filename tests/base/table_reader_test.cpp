// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/table_reader.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

class TableOf : public testing::Test {
protected:
  base::TableReader read(const std::string& text) {
    table_ = base::parseToml(text, "a.toml").value();
    return {table_, "a.toml", ""};
  }
  static std::string problemOf(base::TableReader& reader) {
    const auto error = reader.finish();
    return error ? base::errorSentence(*error) : "";
  }

  toml::table table_;
};

TEST_F(TableOf, WholeNumbersBeyondThoseOfADoubleAreNumbers) {
  auto reader = read("a = 9223372036854775807\nb = [1, 9007199254740993]\n");
  double a = 0.0;
  double b[2] = {};
  reader.readNumber("a", a, 0.0, 1e300);
  EXPECT_TRUE(reader.readNumbers("b", b, 2, 0.0, 1e300));
  EXPECT_EQ(problemOf(reader), "");
  EXPECT_EQ(a, 9223372036854775808.0);
  EXPECT_EQ(b[1], 9007199254740992.0);
}

TEST_F(TableOf, NumbersOutOfTheirRangeAreNone) {
  double number = 0.0;
  double pair[2] = {};
  for (const auto& [text, sentence] :
       {std::pair("a = nan", "nan is not a finite number"),
        std::pair("a = -inf", "-inf is not a finite number"),
        std::pair("a = 9223372036854775807", "9.223372036854776e+18 is not within 0 to 1")}) {
    auto reader = read(text);
    reader.readNumber("a", number, 0.0, 1.0);
    EXPECT_NE(problemOf(reader).find(sentence), std::string::npos) << text;
  }
  auto reader = read("a = [0.5, 9223372036854775807]");
  EXPECT_FALSE(reader.readNumbers("a", pair, 2, 0.0, 1.0));
  EXPECT_NE(problemOf(reader), "");
}

TEST_F(TableOf, MoreTablesThanPossibleAreOneSentence) {
  auto reader = read("[[a]]\n[[a]]\n[[a]]\n");
  EXPECT_TRUE(reader.findTables("a", 2).empty());
  EXPECT_EQ(problemOf(reader), "a.toml: a: not a usable value (3; at most 2 are possible, line 1)");
  auto enough = read("[[a]]\n[[a]]\n[[a]]\n");
  EXPECT_EQ(enough.findTables("a", 3).size(), 3U);
}

} // namespace
} // namespace dewpoint::tests
