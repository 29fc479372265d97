// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/snapshot_builder.h"
#include "tests/session/drawn_recording.h"

#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <utility>

namespace dewpoint::tests {
namespace {

using test::drawnInputs;
using test::DrawnRecording;
using test::eventually;

void iterateTo(Session& session, std::int64_t frame) {
  while (session.newest()->history.newestTrackedFrame < frame) {
    const std::int64_t before = session.newest()->iterationCount;
    session.stepFrame();
    ASSERT_TRUE(eventually([&] { return session.newest()->iterationCount > before; }));
  }
}

TrackSnapshotPtr shown(Session& session, std::int64_t frame) {
  session.showFrame(frame);
  EXPECT_TRUE(
      eventually([&] { return session.newest()->frame == frame && !session.newest()->isPreview; }));
  return session.newest();
}

// What was believed of another number of targets is not continued: neither where the run stands,
// nor where it stood.
TEST(SnapshotBuilder, NewBeliefsBeginNewTails) {
  Session session(drawnInputs("dewpoint", 60));
  iterateTo(session, 9);
  EXPECT_EQ(session.newest()->targets.at(0).tailPositions.size(), 10U);
  Target second = drawn::redBall();
  second.name = "second";
  session.setTargets({drawn::redBall(), second});
  ASSERT_TRUE(eventually([&] { return session.newest()->targets.size() == 2; }));
  EXPECT_TRUE(session.newest()->targets[0].tailPositions.empty()); // nothing is believed yet
  iterateTo(session, 12);
  // The frame they begin in is tracked again: 9, 10, 11, 12.
  EXPECT_EQ(session.newest()->targets.at(0).tailPositions.size(), 4U);
  EXPECT_EQ(session.newest()->targets.at(1).tailPositions.size(), 4U);
  EXPECT_EQ(shown(session, 11)->targets.at(0).tailPositions.size(), 3U);
  EXPECT_EQ(shown(session, 5)->targets.at(0).tailPositions.size(), 6U);
}

TEST(SnapshotBuilder, ARenamedTargetHasItsNewNameInAllFrames) {
  Session session(drawnInputs("dewpoint", 60));
  iterateTo(session, 9);
  EXPECT_GT(session.newest()->sourceFramesPerSecond, 0.0);
  ASSERT_EQ(shown(session, 4)->targets.at(0).target.name, drawn::redBall().name);
  Target renamed = drawn::redBall();
  renamed.name = "renamed";
  session.setTargets({renamed});
  EXPECT_TRUE(eventually([&] { return session.newest()->targets.at(0).target.name == "renamed"; }));
  EXPECT_EQ(session.newest()->frame, 4); // without going anywhere
  EXPECT_EQ(shown(session, 6)->targets.at(0).target.name, "renamed");
}

TEST(SnapshotBuilder, AHiddenTargetIsTrackedOnAsBefore) {
  Session session(drawnInputs("dewpoint", 60));
  Session other(drawnInputs("dewpoint", 60));
  other.setMasksShown(true);
  iterateTo(session, 9);
  iterateTo(other, 9);
  ASSERT_FALSE(other.newest()->masks.at(0).empty());
  Target hidden = drawn::redBall();
  hidden.isShown = false;
  other.setTargets({hidden});
  ASSERT_TRUE(eventually([&] { return !other.newest()->targets.at(0).target.isShown; }));
  EXPECT_TRUE(other.newest()->masks.at(0).empty());
  iterateTo(session, 14);
  iterateTo(other, 14);
  EXPECT_EQ(positionOf(session.newest()->targets.at(0).estimate)->mean,
            positionOf(other.newest()->targets.at(0).estimate)->mean);
  EXPECT_FALSE(shown(other, 4)->targets.at(0).target.isShown); // in earlier frames, too
}

TEST(SnapshotBuilder, AFrameLooksTheSameNowAndLater) {
  SessionInputs inputs = drawnInputs("dewpoint", 60);
  for (std::int64_t frame = 0; frame < 60; ++frame) {
    TrajectorySample truth;
    truth.target = drawn::redBall().name;
    truth.frame = frame;
    truth.position = DrawnRecording::ballAt(frame);
    inputs.truth.samples.push_back(truth);
  }
  Session session(std::move(inputs));
  session.setMasksShown(true);
  iterateTo(session, 20);
  const TrackSnapshotPtr then = session.newest();
  ASSERT_EQ(then->frame, 20);
  iterateTo(session, 21);
  const TrackSnapshotPtr later = shown(session, 20);
  EXPECT_FALSE(then->isPast);
  EXPECT_TRUE(later->isPast);
  EXPECT_TRUE(then->isTracked && later->isTracked);
  EXPECT_EQ(then->iterationCount, later->iterationCount);
  ASSERT_EQ(then->masks.size(), later->masks.size());
  EXPECT_EQ(cv::norm(then->masks[0], later->masks[0], cv::NORM_INF), 0.0);
  const TargetSnapshot& a = then->targets.at(0);
  const TargetSnapshot& b = later->targets.at(0);
  EXPECT_EQ(positionOf(a.estimate)->mean, positionOf(b.estimate)->mean);
  ASSERT_EQ(a.tailPositions.size(), b.tailPositions.size());
  EXPECT_EQ(a.tailPositions.back(), b.tailPositions.back());
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.cameraReports.size(), b.cameraReports.size());
  EXPECT_EQ(a.positionCandidates.size(), b.positionCandidates.size());
  ASSERT_TRUE(a.truth && b.truth);
  EXPECT_EQ(*a.truth, *b.truth);
}

/// Asks for a snapshot of a frame and waits for the answer.
Result<TrackSnapshotPtr> described(Session& session, std::int64_t frame, bool isWanted = true) {
  auto answer = std::make_shared<std::promise<Result<TrackSnapshotPtr>>>();
  auto found = answer->get_future();
  session.describeFrame(
      {.frame = frame,
       .receive =
           [answer](Result<TrackSnapshotPtr> result) { answer->set_value(std::move(result)); },
       .isWanted = [isWanted] { return isWanted; }});
  return found.get();
}

TEST(SnapshotBuilder, AFrameIsDescribedWithoutBeingShown) {
  Session session(drawnInputs("dewpoint", 60));
  session.setMasksShown(true);
  iterateTo(session, 20);
  const TrackSnapshotPtr before = session.newest();
  const auto past = described(session, 12);
  const auto current = described(session, 20);
  const auto later = described(session, 30); // not tracked yet
  ASSERT_TRUE(past && current && later);
  EXPECT_EQ(session.newest(), before); // nothing was published
  EXPECT_EQ((*past)->frame, 12);
  EXPECT_TRUE((*past)->isTracked && (*current)->isTracked);
  EXPECT_FALSE((*later)->isTracked || (*past)->isPreview);
  EXPECT_EQ((*past)->masks.size(), 2U);
  EXPECT_NE((*later)->frames, nullptr);
  const TrackSnapshotPtr shown12 = shown(session, 12);
  EXPECT_EQ(positionOf((*past)->targets.at(0).estimate)->mean,
            positionOf(shown12->targets.at(0).estimate)->mean);
  EXPECT_EQ((*past)->targets[0].tailPositions.size(), shown12->targets[0].tailPositions.size());
  EXPECT_EQ((*past)->targets[0].particles.rows(), shown12->targets[0].particles.rows());
  // The current frame looks like the others: with as many particles as were kept of them.
  EXPECT_EQ((*current)->targets.at(0).particles.rows(), (*past)->targets.at(0).particles.rows());
  EXPECT_EQ((*current)->targets[0].tailPositions.size(), 21U);
}

TEST(SnapshotBuilder, DescribesTheMapsThatAreShown) {
  Session session(drawnInputs("dewpoint", 60));
  iterateTo(session, 20);
  EXPECT_TRUE(described(session, 12).value()->targets.at(0).maps.empty());
  session.setLikelihoodMapsShown(true);
  for (const std::int64_t frame : {12, 13, 20}) {
    EXPECT_EQ(described(session, frame).value()->targets.at(0).maps.size(), 2U) << frame;
  }
}

TEST(SnapshotBuilder, SaysWhyAFrameIsNotDescribed) {
  Session session(drawnInputs("dewpoint", 60));
  iterateTo(session, 3);
  for (const std::int64_t frame : {-1, 60}) {
    const auto missing = described(session, frame);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::NotFound);
  }
  const auto unwanted = described(session, 2, false);
  ASSERT_FALSE(unwanted);
  EXPECT_EQ(unwanted.error().code, ErrorCode::Canceled);
}

} // namespace
} // namespace dewpoint::tests
