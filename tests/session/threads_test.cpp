// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/command_queue.h"
#include "core/session/log/run_log.h"
#include "core/session/snapshot_publisher.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

#include <array>

namespace dewpoint::tests {
namespace {

TEST(CommandQueue, KeepsOrderAndLosesNothing) {
  constexpr std::uint64_t kEach = 2000;
  constexpr std::uint64_t kProducers = 3;
  CommandQueue queue;
  std::vector<std::jthread> producers;
  for (std::uint64_t producer = 0; producer < kProducers; ++producer) {
    producers.emplace_back([&queue, producer] {
      for (std::uint64_t k = 0; k < kEach; ++k) {
        queue.push(command::Restart{producer * kEach + k});
      }
    });
  }
  std::stop_source stop;
  std::array<std::uint64_t, kProducers> seen{};
  for (std::uint64_t k = 0; k < kEach * kProducers; ++k) {
    const auto command = queue.pop(stop.get_token(), std::nullopt);
    ASSERT_TRUE(command.has_value());
    const auto value = std::get<command::Restart>(*command).seed.value();
    auto& expected = seen.at(value / kEach);
    EXPECT_EQ(value % kEach, expected++); // each thread's own commands stay in order
  }
}

TEST(CommandQueue, ComesBackAtTheDeadlineAndWhenStopped) {
  CommandQueue queue;
  std::stop_source stop;
  EXPECT_FALSE(queue.pop(stop.get_token(), std::chrono::steady_clock::now()));
  queue.push(command::Pause{});
  EXPECT_TRUE(queue.pop(stop.get_token(), std::chrono::steady_clock::now())); // overdue, but there
  std::jthread waiting([&] { EXPECT_FALSE(queue.pop(stop.get_token(), std::nullopt)); });
  stop.request_stop();
  waiting.join();
}

TEST(SnapshotPublisher, ReadersSeeWholeSnapshotsInOrder) {
  SnapshotPublisher publisher;
  ASSERT_NE(publisher.newestSnapshot(), nullptr);
  constexpr std::int64_t kLast = 3000;
  std::vector<std::jthread> readers;
  for (int k = 0; k < 2; ++k) {
    readers.emplace_back([&publisher] {
      std::int64_t last = -1;
      while (last < kLast) {
        const auto snapshot = publisher.newestSnapshot();
        EXPECT_GE(snapshot->frame, last);
        EXPECT_TRUE(snapshot->frame < 0 || snapshot->iterationCount == 2 * snapshot->frame);
        last = snapshot->frame;
      }
    });
  }
  int wakes = 0; // guarded by the publisher: the wake-up never runs twice at once
  for (std::int64_t frame = 0; frame <= kLast; ++frame) {
    if (frame == 100) {
      publisher.onSnapshot([&wakes] { ++wakes; });
    }
    if (frame == 600) {
      publisher.onSnapshot(nullptr);
    }
    auto snapshot = std::make_shared<TrackSnapshot>();
    snapshot->frame = frame;
    snapshot->iterationCount = 2 * frame;
    publisher.publish(std::move(snapshot));
  }
  EXPECT_EQ(wakes, 500);
}

TEST(SnapshotPublisher, NeverWakesAfterTheWakeUpWasTakenBack) {
  SnapshotPublisher publisher;
  std::jthread writer([&publisher](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      publisher.publish(std::make_shared<const TrackSnapshot>());
    }
  });
  for (int k = 0; k < 500; ++k) {
    auto alive = std::make_unique<std::atomic<int>>(0);
    publisher.onSnapshot([counter = alive.get()] { ++*counter; });
    publisher.onSnapshot(nullptr);
    alive.reset(); // the sanitizers tell if it is still used
  }
}

TEST(SnapshotPublisher, WhoIsWokenMayReadTheNewest) {
  SnapshotPublisher publisher;
  std::int64_t read = -1;
  publisher.onSnapshot([&] { read = publisher.newestSnapshot()->frame; });
  auto snapshot = std::make_shared<TrackSnapshot>();
  snapshot->frame = 7;
  publisher.publish(std::move(snapshot));
  EXPECT_EQ(read, 7);
}

TEST(RunLog, OldRecordsAreThinnedAndCountedOn) {
  RunLog log;
  std::uint64_t generation = 0;
  std::size_t position = 0;
  log.iterationsSince(generation, position);
  for (int k = 0; k < 250001; ++k) { // more than it keeps
    log.append(std::vector<IterationRecord>{{k, k, 0, 0.0, 0.0, -1.0}});
  }
  const auto piece = log.iterationsSince(generation, position);
  EXPECT_FALSE(piece.restarted);
  ASSERT_FALSE(piece.records.empty());
  EXPECT_LE(piece.records.size(), RunLog::kMaxIterationRecords);
  EXPECT_EQ(piece.records.front().iteration, 0); // the beginning is there, in coarse steps
  for (std::size_t k = 1; k < piece.records.size(); ++k) {
    const auto step = piece.records[k].iteration - piece.records[k - 1].iteration;
    ASSERT_GT(step, 0);
    // Thinned when 100,000 are there, and then after every 25,000 or more: seven times at the most
    // until 250,000, and steps double each time.
    ASSERT_LE(step, 128);
    ASSERT_TRUE(step == 1 || piece.records[k].iteration < 225000); // the newest in full
  }
  EXPECT_EQ(piece.records.back().iteration, 250000);
  EXPECT_EQ(position, 250001U);
  log.append(std::vector<IterationRecord>{{250001, 0, 0, 0.0, 0.0, -1.0}});
  EXPECT_EQ(log.iterationsSince(generation, position).records.size(), 1U);
}

TEST(RunLog, GoingBackForgetsWhatCameLaterAndGivesTheRestAgain) {
  RunLog log;
  std::uint64_t generation = 0;
  std::size_t position = 0;
  for (int k = 0; k < 10; ++k) {
    log.append(std::vector<IterationRecord>{{k, k / 2, 0, 0.0, 0.0, -1.0}});
    TrajectorySample sample;
    sample.frame = k / 2;
    log.append(std::vector<TrajectorySample>{sample});
  }
  EXPECT_EQ(log.iterationsSince(generation, position).records.size(), 10U);
  log.goBack(3); // frames 3 and 4 had two iterations each
  EXPECT_EQ(log.trajectory().samples.size(), 3U);
  auto piece = log.iterationsSince(generation, position);
  EXPECT_TRUE(piece.restarted);
  EXPECT_EQ(piece.records.size(), 6U);
  log.append(std::vector<IterationRecord>{{6, 3, 0, 0.0, 0.0, -1.0}});
  piece = log.iterationsSince(generation, position);
  EXPECT_FALSE(piece.restarted);
  ASSERT_EQ(piece.records.size(), 1U);
  EXPECT_EQ(piece.records[0].frame, 3);
}

TEST(RunLog, IsReadWhileItIsWritten) {
  RunLog log;
  std::jthread writer([&log] {
    for (int run = 0; run < 5; ++run) {
      log.restart({});
      for (int k = 0; k < 1000; ++k) {
        log.append(std::vector<IterationRecord>{{k, k, 0, 0.0, 0.0, -1.0}});
        TrajectorySample sample;
        sample.frame = k / 2; // every frame is recorded twice; the second takes its place
        log.append(std::vector<TrajectorySample>{sample});
      }
    }
  });
  std::uint64_t generation = 0;
  std::size_t position = 0;
  std::int64_t next = 0;
  while (generation < 6 || next < 1000) { // the first run is generation 2, the last 6
    const auto piece = log.iterationsSince(generation, position);
    next = piece.restarted ? 0 : next;
    for (const auto& record : piece.records) {
      ASSERT_EQ(record.iteration, next++);
    }
    ASSERT_LE(log.trajectory().samples.size(), 500U);
  }
  writer.join();
  EXPECT_EQ(log.trajectory().samples.size(), 500U);
}

} // namespace
} // namespace dewpoint::tests
