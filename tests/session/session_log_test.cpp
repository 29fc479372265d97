// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/session.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

namespace dewpoint::tests {
namespace {

using test::eventually;
using test::inputs;
using test::reaches;
using test::showsFrame;

TEST(Session, TheLogIsReadInPiecesAndKnowsRestarts) {
  Session session(inputs());
  std::uint64_t generation = 0;
  std::size_t position = 0;
  ASSERT_TRUE(showsFrame(session));
  EXPECT_TRUE(session.iterationsSince(generation, position).restarted); // a new reader starts anew
  session.stepFrame();
  session.stepFrame();
  ASSERT_TRUE(eventually([&] { return session.newest()->iterationCount == 2; }));
  auto piece = session.iterationsSince(generation, position);
  EXPECT_FALSE(piece.restarted);
  ASSERT_EQ(piece.records.size(), 2U);
  EXPECT_EQ(piece.records[1].iteration, 2);
  EXPECT_EQ(piece.records[1].frame, 1);
  const IterationRecord& record = piece.records[1];
  EXPECT_DOUBLE_EQ(record.frameTime, seconds(timeStamp(1.0 / 30.0))); // of frame 1 at 30 per second
  EXPECT_EQ(record.particleCount, 100);
  EXPECT_GT(record.durationMicroseconds, 0.0);
  // The spread is the root of the trace of the covariance.
  EXPECT_NEAR(record.spreadPerAxis.norm(), record.spread, 1e-9);
  EXPECT_TRUE(record.isConfirmed);
  EXPECT_EQ(record.position, std::get<SphereEstimate>(session.newest()->targets[0].estimate).mean);
  EXPECT_FALSE(record.truth.allFinite()); // nobody knows it
  EXPECT_TRUE(std::isnan(record.boxWidth));
  ASSERT_EQ(record.cameraEvidence.size(), 2U);
  for (const CameraEvidence& camera : record.cameraEvidence) {
    // The start lies on the disc, whose image is larger than the window: all 25 pixels match, so
    // the likelihood is 25/25 and the odds against chance (1/25) are 25 to 1.
    EXPECT_TRUE(camera.isInView);
    EXPECT_DOUBLE_EQ(camera.visibleShare, 1.0);
    EXPECT_DOUBLE_EQ(camera.logLikelihood, 0.0);
    EXPECT_NEAR(camera.existenceProbability, 25.0 / 26.0, 1e-12);
  }
  EXPECT_TRUE(session.iterationsSince(generation, position).records.empty());
  session.restart(5);
  session.stepFrame();
  ASSERT_TRUE(eventually(
      [&] { return session.newest()->seed == 5 && session.newest()->iterationCount == 1; }));
  piece = session.iterationsSince(generation, position);
  EXPECT_TRUE(piece.restarted);
  EXPECT_EQ(piece.records.size(), 1U);
  EXPECT_FALSE(session.iterationsSince(generation, position).restarted);
}

TEST(Session, TheLogHasTheTruthWhereItIsKnown) {
  auto with = inputs();
  TrajectorySample truth;
  truth.target = "ball";
  truth.frame = 0;
  truth.position = test::kBall;
  with.truth.samples = {truth};
  Session session(std::move(with));
  session.stepFrame();
  session.stepFrame(); // frame 1 has no truth
  ASSERT_TRUE(eventually([&] { return session.newest()->iterationCount == 2; }));
  std::uint64_t generation = 0;
  std::size_t position = 0;
  const auto records = session.iterationsSince(generation, position).records;
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].truth, test::kBall);
  EXPECT_EQ(records[0].distanceToTruth, (records[0].position - test::kBall).norm());
  EXPECT_FALSE(records[1].truth.allFinite());
}

TEST(Session, SamplesAreReadInPiecesAndTheLastFrameComesAgain) {
  Session session(inputs());
  ASSERT_TRUE(showsFrame(session));
  std::uint64_t generation = 0;
  std::size_t position = 0;
  session.stepFrame();
  session.stepFrame();
  ASSERT_TRUE(eventually([&] { return session.trajectory().samples.size() == 2; }));
  auto piece = session.samplesSince(generation, position);
  EXPECT_TRUE(piece.restarted);
  EXPECT_EQ(piece.first, 0U);
  ASSERT_EQ(piece.records.size(), 2U);
  // One more iteration on the frame shown: its sample is another one.
  const auto before = piece.records.back().position;
  session.stepIteration();
  ASSERT_TRUE(eventually([&] { return session.trajectory().samples.back().position != before; }));
  piece = session.samplesSince(generation, position);
  EXPECT_FALSE(piece.restarted);
  EXPECT_EQ(piece.first, 1U);
  ASSERT_EQ(piece.records.size(), 1U);
  EXPECT_NE(piece.records[0].position, before);
  // Existence is the one of the estimate.
  EXPECT_EQ(piece.records[0].existenceProbability,
            std::get<SphereEstimate>(session.newest()->targets[0].estimate).existenceProbability);
  session.restart();
  session.stepFrame();
  ASSERT_TRUE(eventually([&] { return session.trajectory().samples.size() == 1; }));
  piece = session.samplesSince(generation, position);
  EXPECT_TRUE(piece.restarted);
  EXPECT_EQ(piece.first, 0U);
  EXPECT_EQ(piece.records.size(), 1U);
}

TEST(Session, NoticesOfLiveCamerasComeAndGoAlsoWhilePausedAndAreLogged) {
  test::FakeRecording::Options options;
  options.frames.reset();
  options.unplugged = std::make_shared<std::atomic<bool>>(false);
  Session session(inputs(options));
  ASSERT_TRUE(eventually([&] { return session.newest()->frame >= 0; }));
  EXPECT_TRUE(session.newest()->notices.empty());
  *options.unplugged = true; // paused
  ASSERT_TRUE(eventually([&] { return session.newest()->notices.size() == 2; }));
  session.play();
  std::uint64_t generation = 0;
  std::size_t position = 0;
  ASSERT_TRUE(eventually([&] { // with each tracked frame, for the timeline
    const auto news = session.framesSince(generation, position);
    return std::ranges::any_of(news.records, [](const FrameRecord& record) {
      return record.cameraProblems != nullptr && record.cameraProblems->size() == 2;
    });
  }));
  *options.unplugged = false;
  ASSERT_TRUE(eventually([&] { return session.newest()->notices.empty(); }));
  session.pause();
  ASSERT_TRUE(reaches(session, PlayState::Paused));
  const RunStatistics figures = session.record().statistics;
  EXPECT_EQ(figures.notices.size(), 2U); // also after they are over
  ASSERT_EQ(figures.noticeLog.periods().size(), 2U);
  EXPECT_TRUE(figures.noticeLog.periods()[0].endSeconds.has_value());
}

} // namespace
} // namespace dewpoint::tests
