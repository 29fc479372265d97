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
  EXPECT_EQ(filterThreads(1), 1);
  EXPECT_EQ(filterThreads(7), 7);
}

TEST(FilterThreads, LeaveOneProcessorToCamerasAndWindow) {
  EXPECT_EQ(filterThreads(0), std::max(1, processors() - 1));
}

TEST(ThreadsForTasks, AreOneEachAsFarAsTheMachineGoes) {
  EXPECT_EQ(threadsForTasks(0), 1);
  EXPECT_EQ(threadsForTasks(1), 1);
  EXPECT_EQ(threadsForTasks(2), std::min(2, processors()));
  EXPECT_EQ(threadsForTasks(1'000'000), processors());
}

} // namespace
} // namespace dewpoint::tests
