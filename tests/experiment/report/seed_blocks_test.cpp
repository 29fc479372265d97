// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/report/experiment_options.h"
#include "core/experiment/report/seed_blocks.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(SeedBlocks, EachSeedIsInOneBlock) {
  std::uint64_t next = 0;
  for (const SeedBlock& block : kSeedBlocks) {
    EXPECT_EQ(block.first, next) << block.name;
    EXPECT_GE(block.last, block.first) << block.name;
    EXPECT_EQ(seedBlockOf(block.first).purpose, block.purpose);
    EXPECT_EQ(seedBlockOf(block.last).purpose, block.purpose);
    next = block.last + 1; // 0 again behind the last one
  }
  EXPECT_EQ(next, 0U);
}

// What people, boxes and the suite were changed on or after.
TEST(SeedBlocks, SeedsThatWereLookedAtAreNotReported) {
  for (const std::uint64_t seed : {1U, 30U, 5001U, 5020U}) {
    EXPECT_EQ(seedBlockOf(seed).purpose, SeedPurpose::Tuning) << seed;
  }
  for (const std::uint64_t seed :
       {1000001U, 1002456U, 1003152U, 1004001U, 1004500U, 1005001U, 1005020U}) {
    EXPECT_EQ(seedBlockOf(seed).purpose, SeedPurpose::Validation) << seed;
  }
  EXPECT_EQ(seedBlockOf(ExperimentOptions().firstSeed).purpose, SeedPurpose::Reporting);
  EXPECT_EQ(seedBlockOf(kFirstTuningSeed).purpose, SeedPurpose::Tuning);
}

TEST(SeedBlocks, ASentenceNamesTheBlockAndWarns) {
  EXPECT_EQ(describeSeeds({}), "none");
  EXPECT_EQ(describeSeeds(kFirstReportingSeed, 20),
            "1006001 to 1006020, 20 in all: reporting seeds, on which no method was tuned");
  EXPECT_NE(describeSeeds(1, 3).find("1 to 3, 3 in all: TUNING"), std::string::npos);
  EXPECT_NE(describeSeeds(1004001, 1).find("VALIDATION"), std::string::npos);
  EXPECT_NE(describeSeeds(7700001, 1).find("RESERVE"), std::string::npos);
  EXPECT_NE(describeSeeds({7, 1006001}).find("tuning and reporting seeds mixed"),
            std::string::npos);
}

TEST(SeedBlocks, OnlyTheReportingBlockIsQuoted) {
  EXPECT_TRUE(areReportingSeeds({kFirstReportingSeed, kLastReportingSeed}));
  EXPECT_FALSE(areReportingSeeds({}));
  EXPECT_FALSE(areReportingSeeds({kFirstReportingSeed - 1, kFirstReportingSeed}));
  EXPECT_FALSE(areReportingSeeds({kFirstReportingSeed, kLastReportingSeed + 1}));
}

} // namespace
} // namespace dewpoint::tests
