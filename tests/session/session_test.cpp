// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/session.h"
#include "core/tracking/catalog/method_catalog.h"
#include "tests/session/fake_recording.h"
#include "tests/session/whole_run.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

using test::eventually;
using test::FakeRecording;
using test::inputs;
using test::playedToTheEnd;
using test::reaches;
using test::showsFrame;

FakeRecording::Options frames(std::optional<std::int64_t> count) {
  FakeRecording::Options options;
  options.frames = count;
  return options;
}

Project projectWithParameter(const char* key, double value) {
  Project project = test::twoCameraProject();
  EXPECT_TRUE(project.parameters.set(key, value));
  return project;
}

TEST(Session, ShowsTheFirstFramePausedAndUntracked) {
  const Session session(inputs());
  ASSERT_NE(session.newest(), nullptr);
  ASSERT_TRUE(showsFrame(session));
  const auto snapshot = session.newest();
  EXPECT_EQ(snapshot->frame, 0);
  EXPECT_EQ(snapshot->state, PlayState::Paused);
  EXPECT_EQ(snapshot->iterationCount, 0);
  EXPECT_EQ(snapshot->frameCount, 12);
  ASSERT_EQ(snapshot->frames->frames.size(), 2U);
  EXPECT_EQ(snapshot->frames->frames[1]->image.cols, 160);
  EXPECT_EQ(snapshot->rig->size(), 2U);
  EXPECT_EQ(snapshot->targets.size(), 1U);
  EXPECT_TRUE(snapshot->notices.empty());
  EXPECT_TRUE(session.trajectory().samples.empty());
}

// A day per iteration is kept by any machine, a femtosecond by none.
TEST(Session, CountsHowOftenTheTimeBudgetIsKept) {
  Session without(inputs());
  playedToTheEnd(without);
  EXPECT_EQ(without.newest()->budget.budgetMilliseconds, 0.0);
  for (const double budget : {1000.0, 1e-12}) {
    Project project = test::twoCameraProject();
    project.method = "dewpoint";
    project.parameters = ParameterValues(methodParameters("dewpoint"));
    EXPECT_TRUE(project.parameters.set("time_budget", budget));
    Session session(inputs({}, project));
    playedToTheEnd(session);
    const BudgetStatistics figures = session.newest()->budget;
    EXPECT_EQ(figures.budgetMilliseconds, budget);
    EXPECT_EQ(figures.iterationCount, 12);
    EXPECT_EQ(figures.lateIterationCount, budget > 1.0 ? 0 : 12);
  }
}

TEST(Session, PlaysToTheEndWithOneSamplePerFrame) {
  Session session(inputs());
  const auto trajectory = playedToTheEnd(session);
  ASSERT_EQ(trajectory.samples.size(), 12U);
  for (std::size_t k = 0; k < trajectory.samples.size(); ++k) {
    EXPECT_EQ(trajectory.samples[k].frame, static_cast<std::int64_t>(k));
    EXPECT_EQ(trajectory.samples[k].target, "ball");
    EXPECT_DOUBLE_EQ(trajectory.samples[k].time, seconds(timeStamp(static_cast<double>(k) / 30.0)));
  }
  // The cloud starts on the disc of both cameras: it stays there, within the ball's radius.
  EXPECT_TRUE(trajectory.samples.back().isValid);
  EXPECT_LT((trajectory.samples.back().position - test::kBall).norm(), test::kBallRadius);
  EXPECT_EQ(session.newest()->targets[0].tailPositions.size(), 12U);
  EXPECT_EQ(session.newest()->iterationCount, 12);
}

TEST(Session, PauseStops) {
  Session session(inputs(frames(1'000'000'000)));
  session.play();
  ASSERT_TRUE(eventually([&] { return session.newest()->frame >= 3; }));
  session.pause();
  ASSERT_TRUE(reaches(session, PlayState::Paused));
  const auto frame = session.newest()->frame;
  session.setMasksShown(true); // commands are obeyed in order: this one comes after the pause
  ASSERT_TRUE(eventually([&] { return !session.newest()->masks.empty(); }));
  EXPECT_EQ(session.newest()->frame, frame);
  EXPECT_EQ(session.newest()->state, PlayState::Paused);
}

TEST(Session, StepFrameDoesOneFrameWithAllItsIterations) {
  Session session(inputs({}, projectWithParameter("iterations_per_frame", 7)));
  for (int step = 1; step <= 3; ++step) {
    session.stepFrame();
    ASSERT_TRUE(eventually([&] { return session.newest()->iterationCount >= 7 * step; }));
    EXPECT_EQ(session.newest()->iterationCount, 7 * step);
    EXPECT_EQ(session.newest()->frame, step - 1); // the first step is on the frame shown at first
    EXPECT_EQ(session.newest()->state, PlayState::Paused);
    EXPECT_EQ(session.trajectory().samples.size(), static_cast<std::size_t>(step));
  }
}

TEST(Session, StepIterationStaysOnTheFrame) {
  Session session(inputs());
  for (int step = 1; step <= 3; ++step) {
    session.stepIteration();
    ASSERT_TRUE(eventually([&] { return session.newest()->iterationCount >= step; }));
    EXPECT_EQ(session.newest()->iterationCount, step);
    EXPECT_EQ(session.newest()->frame, 0);
  }
  session.stepFrame();
  ASSERT_TRUE(eventually([&] { return session.newest()->frame == 1; }));
  EXPECT_EQ(session.newest()->iterationCount, 4);
  EXPECT_EQ(session.trajectory().samples.size(), 2U);
}

TEST(Session, IterationsAfterAFrameReplaceItsSample) {
  Session session(inputs());
  session.stepFrame();
  ASSERT_TRUE(eventually([&] { return session.newest()->iterationCount == 1; }));
  const auto before = session.trajectory();
  session.stepIteration();
  ASSERT_TRUE(eventually([&] { return session.newest()->iterationCount == 2; }));
  const auto after = session.trajectory();
  ASSERT_EQ(after.samples.size(), 1U);
  EXPECT_FALSE(test::sameBits(before, after));
  EXPECT_EQ(session.newest()->targets[0].tailPositions.size(), 1U);
  EXPECT_EQ(playedToTheEnd(session).samples.size(), 12U);
}

TEST(Session, SameSeedSameBitsOtherSeedOtherBits) {
  Session session(inputs());
  const auto first = playedToTheEnd(session);
  session.restart();
  ASSERT_TRUE(reaches(session, PlayState::Paused));
  EXPECT_EQ(session.newest()->frame, 0);
  EXPECT_EQ(session.newest()->iterationCount, 0);
  EXPECT_TRUE(session.trajectory().samples.empty());
  EXPECT_TRUE(test::sameBits(playedToTheEnd(session), first));
  session.restart(2);
  ASSERT_TRUE(reaches(session, PlayState::Paused));
  EXPECT_EQ(session.newest()->seed, 2U);
  const auto other = playedToTheEnd(session);
  EXPECT_EQ(other.samples.size(), first.samples.size());
  EXPECT_FALSE(test::sameBits(other, first));
  session.restart(1);
  ASSERT_TRUE(reaches(session, PlayState::Paused));
  EXPECT_TRUE(test::sameBits(playedToTheEnd(session), first));
}

TEST(Session, PlayAtTheEndStartsAgain) {
  Session session(inputs());
  const auto first = playedToTheEnd(session);
  std::uint64_t generation = 0;
  std::size_t position = 0;
  session.iterationsSince(generation, position);
  session.play();
  ASSERT_TRUE(eventually([&] { return session.iterationsSince(generation, position).restarted; }));
  // The newest snapshot may still be the old end; the log is not.
  ASSERT_TRUE(eventually([&] { return session.trajectory().samples.size() == 12; }));
  EXPECT_TRUE(test::sameBits(session.trajectory(), first));
}

TEST(Session, ParametersActOnTheNextStep) {
  Session session(inputs());
  session.stepFrame();
  ASSERT_TRUE(eventually([&] { return session.newest()->iterationCount == 1; }));
  EXPECT_EQ(std::get<SphereEstimate>(session.newest()->targets[0].estimate).particleCount, 100);
  session.setParameters(projectWithParameter("particles", 350).parameters);
  session.stepFrame();
  ASSERT_TRUE(eventually([&] { return session.newest()->iterationCount == 2; }));
  EXPECT_EQ(std::get<SphereEstimate>(session.newest()->targets[0].estimate).particleCount, 350);
  EXPECT_EQ(session.newest()->targets[0].particles.rows(), 350);
  EXPECT_EQ(session.newest()->targets[0].weights.size(), 350);
}

TEST(Session, TargetsActOnTheNextStep) {
  Session session(inputs());
  auto targets = test::twoCameraProject().targets;
  targets[0].color = {100.0, 140.0, 0.25, 0.65, 0.15, 0.9}; // green: nothing in the pictures
  session.setTargets(targets);
  session.stepFrame();
  ASSERT_TRUE(eventually([&] { return session.newest()->iterationCount == 1; }));
  EXPECT_EQ(std::get<SphereEstimate>(session.newest()->targets[0].estimate).seeingCameraCount, 0);
  EXPECT_EQ(session.newest()->targets[0].target.color, targets[0].color);
}

TEST(Session, MasksOnlyWhenWanted) {
  Session session(inputs());
  ASSERT_TRUE(showsFrame(session));
  EXPECT_TRUE(session.newest()->masks.empty());
  session.setMasksShown(true);
  ASSERT_TRUE(eventually([&] { return session.newest()->masks.size() == 2; }));
  const auto shown = session.newest();
  for (std::size_t k = 0; k < 2; ++k) {
    cv::Mat disc;
    cv::inRange(shown->frames->frames[k]->image, test::kDiscColor, test::kDiscColor, disc);
    EXPECT_EQ(cv::norm(disc, shown->masks[k], cv::NORM_INF), 0.0);
    EXPECT_GT(cv::countNonZero(disc), 200); // a disc of radius 10
  }
  session.setMasksShown(false);
  EXPECT_TRUE(eventually([&] { return session.newest()->masks.empty(); }));
}

TEST(Session, MasksTellTheTargetsApart) {
  SessionInputs two = inputs();
  Target all = two.project.targets.front(); // every color, and so the disc's as well
  all.name = "all";
  all.color = {0.0, 360.0, 0.0, 1.0, 0.0, 1.0};
  two.project.targets.push_back(all);
  Session session(std::move(two));
  ASSERT_TRUE(showsFrame(session));
  session.setMasksShown(true);
  ASSERT_TRUE(eventually([&] { return session.newest()->masks.size() == 2; }));
  const auto shown = session.newest();
  cv::Mat disc;
  cv::inRange(shown->frames->frames[0]->image, test::kDiscColor, test::kDiscColor, disc);
  EXPECT_EQ(cv::norm(disc, shown->masks[0] == 255, cv::NORM_INF), 0.0); // the first one's
  EXPECT_GT(cv::countNonZero(shown->masks[0] == 254), 200);             // the second one's
}

TEST(Session, ABrokenRecordingEndsWithANoticeAndKeepsWhatWasTracked) {
  auto options = frames(12);
  options.failsAt = 5;
  Session session(inputs(options));
  const auto trajectory = playedToTheEnd(session);
  EXPECT_EQ(trajectory.samples.size(), 5U);
  ASSERT_EQ(session.newest()->notices.size(), 1U);
  EXPECT_EQ(session.newest()->notices[0].code, ErrorCode::EndedEarly);
  EXPECT_EQ(session.newest()->notices[0].file, "left.mkv");
  EXPECT_EQ(session.newest()->frame, 4);
  session.stepFrame(); // nothing further to step to, and no second notice
  session.setMasksShown(true);
  ASSERT_TRUE(eventually([&] { return !session.newest()->masks.empty(); }));
  EXPECT_EQ(session.newest()->notices.size(), 1U);
  EXPECT_EQ(session.newest()->state, PlayState::Ended);
}

TEST(Session, ASourceBrokenFromTheStartStaysEnded) {
  auto options = frames(12);
  options.failsAt = 0;
  Session session(inputs(options));
  ASSERT_TRUE(reaches(session, PlayState::Ended));
  session.play();
  session.stepIteration();
  session.stepFrame();
  session.restart(9);
  ASSERT_TRUE(eventually([&] { return session.newest()->seed == 9; }));
  EXPECT_EQ(session.newest()->state, PlayState::Ended);
  EXPECT_EQ(session.newest()->notices.size(), 1U);
  EXPECT_EQ(session.newest()->frame, -1);
}

TEST(Session, LiveWaitsThroughEmptySets) {
  auto options = frames(std::nullopt);
  options.delivering = std::make_shared<std::atomic<bool>>(false);
  Session session(inputs(options));
  session.play();
  ASSERT_TRUE(reaches(session, PlayState::Playing));
  session.setMasksShown(true); // nothing to mask yet: must not matter
  EXPECT_EQ(session.newest()->frame, -1);
  EXPECT_FALSE(session.newest()->frameCount.has_value());
  *options.delivering = true;
  ASSERT_TRUE(eventually([&] { return session.trajectory().samples.size() >= 3; }));
  *options.delivering = false;
  session.pause();
  ASSERT_TRUE(reaches(session, PlayState::Paused));
  const auto iterations = session.newest()->iterationCount;
  session.stepFrame(); // nothing comes: the old frame is not tracked a second time
  session.setMasksShown(false);
  ASSERT_TRUE(eventually([&] { return session.newest()->masks.empty(); }));
  EXPECT_EQ(session.newest()->iterationCount, iterations);
  session.restart(7); // forgets the frame, waits for another
  ASSERT_TRUE(eventually([&] { return session.newest()->seed == 7; }));
  EXPECT_EQ(session.newest()->frame, -1);
  *options.delivering = true;
  session.play();
  ASSERT_TRUE(eventually([&] { return session.trajectory().samples.size() >= 3; }));
}

TEST(Session, AnUnknownMethodIsANotice) {
  auto project = test::twoCameraProject();
  project.method = "guess";
  Session session(inputs({}, project));
  ASSERT_TRUE(eventually([&] { return !session.newest()->notices.empty(); }));
  EXPECT_EQ(session.newest()->notices[0].code, ErrorCode::NotFound);
  session.play();
  session.stepFrame();
}

TEST(Session, PlaysWithoutTargets) {
  auto project = test::twoCameraProject();
  project.targets.clear();
  Session session(inputs({}, project));
  EXPECT_TRUE(playedToTheEnd(session).samples.empty());
  EXPECT_EQ(session.newest()->frame, 11);
}

TEST(Session, TruthGivesErrors) {
  auto with = inputs();
  TrajectorySample truth;
  truth.target = "ball";
  truth.frame = 0;
  truth.position = test::kBall;
  with.truth.samples = {truth};
  Session session(std::move(with));
  session.stepFrame();
  ASSERT_TRUE(eventually([&] { return session.newest()->iterationCount == 1; }));
  const auto snapshot = session.newest();
  ASSERT_TRUE(snapshot->targets[0].truth.has_value());
  std::uint64_t generation = 0;
  std::size_t position = 0;
  const auto piece = session.iterationsSince(generation, position);
  ASSERT_EQ(piece.records.size(), 1U);
  EXPECT_EQ(piece.records[0].distanceToTruth,
            (std::get<SphereEstimate>(snapshot->targets[0].estimate).mean -
             snapshot->targets[0].truth.value())
                .norm());
  session.stepFrame(); // frame 1 has no truth
  ASSERT_TRUE(eventually([&] { return session.newest()->iterationCount == 2; }));
  EXPECT_FALSE(session.newest()->targets[0].truth.has_value());
  EXPECT_LT(session.iterationsSince(generation, position).records.at(0).distanceToTruth, 0.0);
}

TEST(Session, WakesOncePerSnapshotUntilToldNotTo) {
  std::atomic<int> wakes{0};
  std::atomic<bool> pending{false};
  {
    Session session(inputs());
    // As a window does it: one posted event at a time, however many snapshots there are.
    session.onSnapshot([&] {
      if (!pending.exchange(true)) {
        ++wakes;
      }
    });
    session.play();
    ASSERT_TRUE(eventually([&] {
      pending = false;
      return session.newest()->state == PlayState::Ended;
    }));
    EXPECT_GE(wakes, 1);
    session.restart();
    session.play();
    session.onSnapshot(nullptr); // from here on never again, also while playing
    pending = false;
    const int before = wakes;
    ASSERT_TRUE(eventually([&] { return session.trajectory().samples.size() == 12; }));
    EXPECT_EQ(wakes, before);
  }
  EXPECT_FALSE(pending);
}

TEST(Session, IsDestroyedCleanlyWhilePlaying) {
  for (int k = 0; k < 20; ++k) {
    auto options = frames(k % 2 == 0 ? std::optional<std::int64_t>(1'000'000) : std::nullopt);
    if (k % 4 == 1) {
      options.delivering = std::make_shared<std::atomic<bool>>(false);
    }
    TrackSnapshotPtr kept;
    {
      Session session(inputs(options));
      session.play();
      if (k % 3 != 0) {
        ASSERT_TRUE(reaches(session, PlayState::Playing));
      }
      kept = session.newest();
    }
    EXPECT_NE(kept, nullptr); // a snapshot outlives its session
    EXPECT_TRUE(!kept->frames || kept->frames->frames.size() == 2);
  }
}

} // namespace
} // namespace dewpoint::tests
