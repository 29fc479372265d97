// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/entered_place.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

std::optional<EnteredPosition> enteredIn(const char* text, QLocale::Language language) {
  return parseEnteredPosition(QString::fromUtf8(text), QLocale(language));
}

std::optional<EnteredPosition> enteredInEnglish(const char* text) {
  return enteredIn(text, QLocale::English);
}

TEST(EnteredPosition, AFrameIsCountedFromOne) {
  EXPECT_EQ(enteredInEnglish("132"), EnteredPosition(qint64{131}));
  EXPECT_EQ(enteredInEnglish(" 1 "), EnteredPosition(qint64{0}));
  EXPECT_EQ(enteredInEnglish("1,200"), EnteredPosition(qint64{1199}));
  EXPECT_EQ(enteredIn("1.200", QLocale::German), EnteredPosition(qint64{1199}));
  EXPECT_EQ(enteredInEnglish("0"),
            EnteredPosition(qint64{-1})); // whether it exists is checked elsewhere
}

TEST(EnteredPosition, ATimeHasItsUnit) {
  EXPECT_EQ(enteredInEnglish("2.5 s"), EnteredPosition(2.5));
  EXPECT_EQ(enteredInEnglish("2.5s"), EnteredPosition(2.5));
  EXPECT_EQ(enteredInEnglish("4 S"), EnteredPosition(4.0));
  EXPECT_EQ(enteredIn("2,5 s", QLocale::German), EnteredPosition(2.5));
  EXPECT_EQ(enteredIn("2.5 s", QLocale::German), EnteredPosition(2.5));
  EXPECT_EQ(enteredIn("2.500 s", QLocale::German), EnteredPosition(2.5)); // not 2500
}

TEST(EnteredPosition, OtherTextsNameNoPlace) {
  for (const char* text : {"", " ", "s", "x", "2.5", "1 2", "2.5 m", "nan s", "inf s", "1e999 s",
                           "99999999999999999999", "-9223372036854775808"}) {
    EXPECT_EQ(enteredInEnglish(text), std::nullopt) << text;
  }
}

} // namespace
} // namespace dewpoint::tests
