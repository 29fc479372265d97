// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/command_palette.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(PaletteSearch, BeginningsOfWordsFitBetterThanTheirMiddle) {
  const int atStart = matchScore("mask", "Show mask");
  const int inside = matchScore("ask", "Show mask");
  EXPECT_GT(atStart, inside);
  EXPECT_GE(inside, 0);
  EXPECT_GT(matchScore("show mask", "Show mask"),
            matchScore("mask show", "Show mask"));    // as it was typed
  EXPECT_GE(matchScore("mask show", "Show mask"), 0); // in any order
}

TEST(PaletteSearch, CaseAndGroupsDoNotCount) {
  EXPECT_EQ(matchScore("MASK", "Show mask"), matchScore("mask", "Show mask"));
  EXPECT_EQ(matchScore("view › mask", "View Show mask"),
            matchScore("view  mask", "View Show mask"));
}

TEST(PaletteSearch, AWordThatBeginsSomewhereCountsAsABeginning) {
  // "at" is within "rate" and begins "at": the better place counts.
  EXPECT_EQ(matchScore("at", "rate at"), matchScore("at", "at rate"));
}

TEST(PaletteSearch, ScatteredLettersFitBelowWords) {
  const int scattered = matchScore("sm", "Show mask");
  EXPECT_LT(scattered, 0);
  EXPECT_GT(scattered, kNoMatch);
  EXPECT_GT(scattered, matchScore("hm", "Show mask")); // beginnings of words are better
  EXPECT_EQ(matchScore("ms", "Showm"), kNoMatch);      // only in their order
  EXPECT_EQ(matchScore("xyz", "Show mask"), kNoMatch);
}

TEST(PaletteSearch, JapaneseWordsBeginAnywhere) {
  EXPECT_EQ(matchScore(QStringLiteral("保存"), QStringLiteral("名前を付けて保存")),
            matchScore(QStringLiteral("保存"), QStringLiteral("保存")));
}

TEST(PaletteSearch, WhereWordsWereFoundScatteredLettersAreNoFit) {
  std::vector<int> fits{matchScore("mask", "Show mask"), matchScore("mask", "Make a sketch"),
                        kNoMatch};
  ASSERT_LT(fits[1], 0);
  ASSERT_GT(fits[1], kNoMatch);
  std::vector<int> scattered{fits[1], kNoMatch};
  dropScatteredMatches(fits);
  EXPECT_GE(fits[0], 0);
  EXPECT_EQ(fits[1], kNoMatch);
  const auto before = scattered;
  dropScatteredMatches(scattered); // nothing better was found
  EXPECT_EQ(scattered, before);
}

} // namespace
} // namespace dewpoint::tests
