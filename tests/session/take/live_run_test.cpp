// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/take/live_run.h"
#include "tests/capture/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace dewpoint::tests {
namespace {

using namespace std::chrono_literals;

LiveFrameRecord liveSet(std::int64_t index,
                        const std::vector<std::optional<std::int64_t>>& stamps) {
  LiveFrameRecord set{index, TimeStamp(index * 1000), {}};
  for (const auto& stamp : stamps) {
    set.images.push_back(
        stamp ? std::optional(LiveFrameRecord::Image{*stamp, TimeStamp(index * 1000 + 7)})
              : std::nullopt);
  }
  return set;
}

std::int64_t numberIn(const StoredFrameSet& set, std::size_t camera) {
  return set.images[camera] ? set.images[camera]->numberInVideo : -2;
}

TEST(LiveRun, ImagesAreFoundByTheirStamps) {
  // The second camera sent no image in frame 6, and lost one in frame 7.
  const auto stored = locateStoredFrameSets({liveSet(5, {10, 11}), liveSet(6, {20, std::nullopt}),
                                             liveSet(7, {30, 31}), liveSet(9, {40, 41})},
                                            {{10, 20, 30, 40}, {11, 41}});
  ASSERT_EQ(stored.size(), 4U);
  EXPECT_EQ(stored[0].index, 5);
  EXPECT_EQ(numberIn(stored[0], 1), 0);
  EXPECT_EQ(numberIn(stored[1], 0), 1);
  EXPECT_EQ(numberIn(stored[1], 1), -2);
  EXPECT_EQ(numberIn(stored[2], 1), -1);
  EXPECT_EQ(numberIn(stored[3], 1), 1);
  EXPECT_EQ(stored[3].images[1]->captureTime, TimeStamp(9007));
}

TEST(LiveRun, AStampThatComesBackAfterAReconnectionIsTheLaterImage) {
  const auto stored =
      locateStoredFrameSets({liveSet(0, {10}), liveSet(1, {20}), liveSet(2, {10})}, {{10, 20, 10}});
  EXPECT_EQ(numberIn(stored[0], 0), 0);
  EXPECT_EQ(numberIn(stored[2], 0), 2);
}

TEST(LiveRun, FramesAfterTheTakeAreLeftOut) {
  EXPECT_EQ(
      locateStoredFrameSets({liveSet(0, {10}), liveSet(1, {20}), liveSet(2, {30})}, {{10}}).size(),
      1U);
  EXPECT_TRUE(locateStoredFrameSets({liveSet(0, {10})}, {{20}}).empty());
}

TEST(LiveRun, TheTableReadsBack) {
  const test::TemporaryFolder folder;
  const auto stored = locateStoredFrameSets({liveSet(5, {10, 11}), liveSet(6, {20, std::nullopt}),
                                             liveSet(7, {30, 99}), liveSet(8, {40, 41})},
                                            {{10, 20, 30, 40}, {11, 41}});
  const std::string file = folder / "frames.csv";
  ASSERT_TRUE(writeStoredFrameSets(stored, file));
  const auto read = readStoredFrameSets(file, 2);
  ASSERT_TRUE(read) << errorSentence(read.error());
  ASSERT_EQ(read->size(), stored.size());
  for (std::size_t k = 0; k < stored.size(); ++k) {
    EXPECT_EQ((*read)[k].index, stored[k].index);
    EXPECT_EQ((*read)[k].time, stored[k].time);
    for (std::size_t camera = 0; camera < 2; ++camera) {
      EXPECT_EQ(numberIn((*read)[k], camera), numberIn(stored[k], camera));
    }
  }
  EXPECT_EQ(readStoredFrameSets(file, 3).error().code, ErrorCode::NotParsed);
  std::ofstream(file, std::ios::app) << "9,x,1,2,3,4\n";
  const auto broken = readStoredFrameSets(file, 2);
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().field, "line 7");
  EXPECT_EQ(readStoredFrameSets(folder / "none.csv", 2).error().code, ErrorCode::FileMissing);
}

TEST(LiveRun, ATableWithNumbersOfNoRunIsRefused) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "frames.csv";
  for (const char* row :
       {"-1,0,0,0", "10000000001,0,0,0", "9223372036854775807,0,0,0", "0,0,-2,0",
        "0,0,10000000001,0", "0,9223372036854775807,0,0", "0,0,0,-9223372036854775807"}) {
    std::ofstream(file) << "1,1000,0,1007\n" << row << "\n";
    const auto read = readStoredFrameSets(file, 1);
    ASSERT_FALSE(read) << row;
    EXPECT_EQ(read.error().code, ErrorCode::NotParsed);
    EXPECT_EQ(read.error().field, "line 2");
  }
}

} // namespace
} // namespace dewpoint::tests
