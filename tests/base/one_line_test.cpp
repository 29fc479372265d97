// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/base/one_line.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(OneLine, KeepsWhatIsPlain) {
  const std::string text = "Größe: 3 m, \xE2\x82\xAC, \xF0\x9F\x98\x80";
  EXPECT_EQ(base::toSingleLine(text), text);
  EXPECT_EQ(base::toSingleLine(""), "");
}

TEST(OneLine, CountsTheBytesOfTheFirstCharacter) {
  EXPECT_EQ(base::utf8CharacterSize("a\xE2\x82\xAC"), 1U);
  EXPECT_EQ(base::utf8CharacterSize("\xE2\x82\xAC and more"), 3U);
  EXPECT_EQ(base::utf8CharacterSize("\x80"), 0U);
  EXPECT_EQ(base::utf8CharacterSize(""), 0U);
  EXPECT_EQ(base::utf8CharacterSize(std::string_view()), 0U) << "there is no first byte to read";
}

TEST(OneLine, HasNoControlCharactersAndIsUtf8) {
  EXPECT_EQ(base::toSingleLine(std::string("a\nb\r\tc\0d\x7F", 9)), "a?b??c?d?");
  // Bytes that begin or go on with nothing, an overlong slash, a surrogate, beyond U+10FFFF, cut
  // off.
  EXPECT_EQ(base::toSingleLine("\xFF\x80|\xC0\xAF|\xED\xA0\x80|\xF4\x90\x80\x80|\xE2\x82"),
            "??|??|???|????|??");
}

TEST(OneLine, IsCutWhereItIsLong) {
  const std::string line = base::toSingleLine(std::string(1'000'000, 'x'));
  EXPECT_EQ(line.size(), 4003U);
  EXPECT_TRUE(line.ends_with("x..."));
}

TEST(OneLine, IsEachPartOfASentence) {
  const Error error{ErrorCode::BadValue, "a\nb.toml", "c\x01", "d\r"};
  EXPECT_EQ(base::errorSentence(error), "a?b.toml: c?: not a usable value (d?)");
}

} // namespace
} // namespace dewpoint::tests
