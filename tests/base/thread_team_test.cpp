// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/thread_team.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <vector>

namespace dewpoint::tests {
namespace {

TEST(ThreadTeam, VisitsEveryElementOnceForAnySize) {
  for (const int threads : {1, 2, 3, 4}) {
    ThreadTeam team(threads);
    EXPECT_EQ(team.threadCount(), threads);
    for (const std::int64_t count : {0, 1, 7, 2047, 2048, 2049, 10001}) {
      std::vector<int> visits(static_cast<std::size_t>(count), 0);
      team.forEachRange(count, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
          ++visits[static_cast<std::size_t>(i)];
        }
      });
      for (const int visit : visits) {
        ASSERT_EQ(visit, 1) << threads << " threads, " << count << " elements";
      }
    }
  }
}

TEST(ThreadTeam, LongRangesAreCutOnePiecePerThread) {
  ThreadTeam team(4);
  std::atomic<int> pieces = 0;
  team.forEachRange(100000, [&](std::int64_t, std::int64_t) { ++pieces; });
  EXPECT_EQ(pieces, 4);
}

TEST(ThreadTeam, RunsManyLoopsInARow) {
  ThreadTeam team(3);
  std::atomic<std::int64_t> total = 0;
  for (int loop = 0; loop < 2000; ++loop) {
    team.forEachRange(3000, [&](std::int64_t begin, std::int64_t end) { total += end - begin; });
  }
  EXPECT_EQ(total, 2000 * 3000);
}

TEST(ThreadTeam, BlocksBeginAtMultiplesOfTheirSize) {
  for (const int threads : {1, 2, 3, 4}) {
    ThreadTeam team(threads);
    for (const std::int64_t count : {0, 1, 7, 999, 1000, 1001, 2048, 10001}) {
      std::vector<int> visits(static_cast<std::size_t>(count), 0);
      std::atomic<int> badBlocks = 0;
      team.forEachBlock(count, 1000, [&](std::int64_t begin, std::int64_t end) {
        badBlocks +=
            begin % 1000 == 0 && end == std::min<std::int64_t>(count, begin + 1000) ? 0 : 1;
        for (std::int64_t i = begin; i < end; ++i) {
          ++visits[static_cast<std::size_t>(i)];
        }
      });
      EXPECT_EQ(badBlocks, 0);
      EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), count) << threads << " threads";
    }
  }
}

} // namespace
} // namespace dewpoint::tests
