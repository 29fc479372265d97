// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/recorded_run.h"
#include "core/session/run/tracking_clock.h"
#include "tests/session/drawn_recording.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>

namespace dewpoint::tests {
namespace {

using Told = std::vector<std::pair<std::int64_t, std::optional<std::int64_t>>>;

RunProgress always() {
  return [](std::int64_t, std::optional<std::int64_t>) { return true; };
}

TEST(RecordedRun, KeepsWhatIsFoundInEachFrame) {
  const Project project = test::drawnInputs("dewpoint", 8).project;
  test::DrawnRecording source(8);
  Told told;
  const auto run =
      recordRun(project, source, {}, {{2, 6}, 1, 20}, [&](std::int64_t done, auto total) {
        told.emplace_back(done, total);
        return true;
      });
  ASSERT_TRUE(run);
  EXPECT_EQ(told, (Told{{0, 4}, {1, 4}, {2, 4}, {3, 4}, {4, 4}}));
  EXPECT_TRUE(run->isFinished);
  EXPECT_FALSE(run->endError);
  EXPECT_EQ(run->frameCount, 4);
  EXPECT_EQ(run->targetNames, std::vector<std::string>{"ball"});
  ASSERT_EQ(run->trajectory.samples.size(), 4U);
  EXPECT_EQ(run->trajectory.samples.front().frame, 2);
  EXPECT_EQ(run->particles.size(), 4U);
  const ParticleSample& particles = run->particles.at({5, 0});
  EXPECT_EQ(particles.positions.rows(), particles.weights.size());
  EXPECT_GT(particles.weights.size(), 0);
  EXPECT_LE(particles.weights.size(), 20);
  EXPECT_EQ(run->trajectory.header.entries, trajectoryHeader(project).entries);
}

TEST(RecordedRun, EndsEarlyOnRequestAndKeepsTheRest) {
  const Project project = test::drawnInputs("barrera", 8).project;
  test::DrawnRecording source(8);
  const auto run = recordRun(project, source, {}, {},
                             [](std::int64_t done, auto /*total*/) { return done < 3; });
  ASSERT_TRUE(run);
  EXPECT_FALSE(run->isFinished);
  EXPECT_EQ(run->trajectory.samples.size(), 3U);
  EXPECT_TRUE(run->particles.empty());
  // Too late to matter.
  test::DrawnRecording again(3);
  const auto whole =
      recordRun(project, again, {}, {}, [](std::int64_t done, auto /*total*/) { return done < 3; });
  EXPECT_TRUE(whole->isFinished);
}

TEST(RecordedRun, KeepsTheFramesBeforeARecordingBreaksOff) {
  const Project project = test::twoCameraProject();
  test::FakeRecording source({.frames = 12, .failsAt = 5, .delivering = {}});
  const auto run = recordRun(project, source, {}, {}, always());
  ASSERT_TRUE(run);
  EXPECT_FALSE(run->isFinished);
  EXPECT_EQ(run->frameCount, 5);
  ASSERT_TRUE(run->endError);
  EXPECT_EQ(run->endError->code, ErrorCode::EndedEarly);
  test::FakeRecording broken({.frames = 12, .failsAt = 0, .delivering = {}});
  EXPECT_FALSE(recordRun(project, broken, {}, {}, always()));
}

TEST(RecordedRun, ObserversAreToldOfTheFrames) {
  const Project project = test::twoCameraProject();
  test::FakeRecording source({.frames = 3, .failsAt = {}, .delivering = {}});
  TrackingClock clock;
  const std::array<FrameObserver*, 1> observers{&clock};
  RecordRunOptions order;
  order.observers = observers;
  EXPECT_EQ(clock.seconds(), 0.0);
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_TRUE(recordRun(project, source, {}, order, always()));
  const std::chrono::duration<double> all = std::chrono::steady_clock::now() - begin;
  EXPECT_GT(clock.seconds(), 0.0);
  EXPECT_LT(clock.seconds(), all.count()); // images and watches take time, too
}

TEST(RecordedRun, NeedsSomethingToFollow) {
  Project project = test::twoCameraProject();
  project.targets.clear();
  test::FakeRecording source({});
  const auto run = recordRun(project, source, {}, {}, always());
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().field, "target");
}

} // namespace
} // namespace dewpoint::tests
