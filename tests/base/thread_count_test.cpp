// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/thread_count.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace dewpoint::tests {
namespace {

int processors() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

TEST(FilterThreads, AreAsWanted) {
  EXPECT_EQ(threadCountForFilter(1), 1);
  EXPECT_EQ(threadCountForFilter(7), 7);
}

TEST(FilterThreads, LeaveOneProcessorToCamerasAndWindow) {
  EXPECT_EQ(threadCountForFilter(0), std::max(1, processors() - 1));
}

TEST(ThreadsForTasks, AreOneEachAsFarAsTheMachineGoes) {
  EXPECT_EQ(threadCountForTasks(0), 1);
  EXPECT_EQ(threadCountForTasks(1), 1);
  EXPECT_EQ(threadCountForTasks(2), std::min(2, processors()));
  EXPECT_EQ(threadCountForTasks(1'000'000), processors());
}

} // namespace
} // namespace dewpoint::tests
