// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/command_palette.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(PaletteSearch, BeginningsOfWordsFitBetterThanTheirMiddle) {
  const int atStart = fitOf("mask", "Show mask");
  const int inside = fitOf("ask", "Show mask");
  EXPECT_GT(atStart, inside);
  EXPECT_GE(inside, 0);
  EXPECT_GT(fitOf("show mask", "Show mask"), fitOf("mask show", "Show mask")); // as it was typed
  EXPECT_GE(fitOf("mask show", "Show mask"), 0);                               // in any order
}

TEST(PaletteSearch, CaseAndGroupsDoNotCount) {
  EXPECT_EQ(fitOf("MASK", "Show mask"), fitOf("mask", "Show mask"));
  EXPECT_EQ(fitOf("view › mask", "View Show mask"), fitOf("view  mask", "View Show mask"));
}

TEST(PaletteSearch, AWordThatBeginsSomewhereCountsAsABeginning) {
  // "at" is within "rate" and begins "at": the better place counts.
  EXPECT_EQ(fitOf("at", "rate at"), fitOf("at", "at rate"));
}

TEST(PaletteSearch, ScatteredLettersFitBelowWords) {
  const int scattered = fitOf("sm", "Show mask");
  EXPECT_LT(scattered, 0);
  EXPECT_GT(scattered, kNoFit);
  EXPECT_GT(scattered, fitOf("hm", "Show mask")); // beginnings of words are better
  EXPECT_EQ(fitOf("ms", "Showm"), kNoFit);        // only in their order
  EXPECT_EQ(fitOf("xyz", "Show mask"), kNoFit);
}

TEST(PaletteSearch, JapaneseWordsBeginAnywhere) {
  EXPECT_EQ(fitOf(QStringLiteral("保存"), QStringLiteral("名前を付けて保存")),
            fitOf(QStringLiteral("保存"), QStringLiteral("保存")));
}

TEST(PaletteSearch, WhereWordsWereFoundScatteredLettersAreNoFit) {
  std::vector<int> fits{fitOf("mask", "Show mask"), fitOf("mask", "Make a sketch"), kNoFit};
  ASSERT_LT(fits[1], 0);
  ASSERT_GT(fits[1], kNoFit);
  std::vector<int> scattered{fits[1], kNoFit};
  dropScattered(fits);
  EXPECT_GE(fits[0], 0);
  EXPECT_EQ(fits[1], kNoFit);
  const auto before = scattered;
  dropScattered(scattered); // nothing better was found
  EXPECT_EQ(scattered, before);
}

} // namespace
} // namespace dewpoint::tests
