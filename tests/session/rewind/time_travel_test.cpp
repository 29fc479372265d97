// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/session/drawn_recording.h"
#include "tests/session/fading_recording.h"
#include "tests/session/whole_run.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <map>

namespace dewpoint::tests {
namespace {

using test::drawnInputs;
using test::DrawnRecording;
using test::eventually;
using test::FadingRecording;
using test::playedToTheEnd;
using test::reaches;
using test::sameBits;

constexpr std::int64_t kTravelFrames = 90;

bool shows(const Session& session, std::int64_t frame) {
  return eventually(
      [&] { return session.newest()->frame == frame && !session.newest()->isPreview; });
}

bool samePixels(const FrameSet& a, const FrameSet& b) {
  bool same = a.frames.size() == b.frames.size();
  for (std::size_t k = 0; same && k < a.frames.size(); ++k) {
    same = (a.frames[k] == nullptr) == (b.frames[k] == nullptr);
    same = same &&
           (!a.frames[k] || cv::norm(a.frames[k]->image, b.frames[k]->image, cv::NORM_INF) == 0.0);
  }
  return same;
}

/// Whether the places are the same, and missing in the same frames.
bool sameTail(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b) {
  return std::ranges::equal(a, b, [](const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
    return one == other || (one.hasNaN() && other.hasNaN());
  });
}

/// Tracks again from this frame, to the end.
void rerun(Session& session, std::int64_t from, std::size_t samples = kTravelFrames) {
  ASSERT_NO_FATAL_FAILURE(test::beginRerun(session, from));
  ASSERT_TRUE(eventually([&] { return session.trajectory().samples.size() == samples; }));
}

/// The first samples of a trajectory, of frames before `frame`.
Trajectory until(Trajectory trajectory, std::int64_t frame) {
  std::erase_if(trajectory.samples, [&](const auto& sample) { return sample.frame >= frame; });
  return trajectory;
}

/// Method, and bytes of history: much, or so little that most copies and particles are given up.
using Case = std::pair<const char*, std::size_t>;

class TimeTravelTest : public ::testing::TestWithParam<Case> {
protected:
  static SessionInputs inputs(bool live = false) {
    SessionInputs result = drawnInputs(GetParam().first, kTravelFrames, live);
    result.maxHistoryBytes = GetParam().second;
    return result;
  }
};

TEST_P(TimeTravelTest, ShowsEveryMomentAsItWas) {
  Session session(inputs());
  std::map<std::int64_t, TrackSnapshotPtr> seen;
  for (std::int64_t frame = 0; frame < kTravelFrames; ++frame) {
    session.stepFrame();
    ASSERT_TRUE(eventually([&] { return session.newest()->history.newestTrackedFrame == frame; }));
    seen[frame] = session.newest();
  }
  for (const std::int64_t frame : {0, 88, 12, 11, 10, 9, 8, 31, 64, 65, 40}) {
    session.showFrame(frame);
    ASSERT_TRUE(shows(session, frame));
    const auto now = session.newest();
    const auto then = seen[frame];
    EXPECT_TRUE(now->isPast);
    EXPECT_TRUE(now->isTracked);
    EXPECT_EQ(now->state, PlayState::Paused);
    EXPECT_EQ(now->history.newestTrackedFrame, kTravelFrames - 1);
    EXPECT_EQ(now->history.lastFrame, kTravelFrames - 1);
    EXPECT_EQ(now->iterationCount, then->iterationCount);
    EXPECT_TRUE(samePixels(*now->frames, *then->frames)) << frame;
    ASSERT_EQ(now->targets.size(), 1U);
    EXPECT_EQ(std::get<SphereEstimate>(now->targets[0].estimate).mean,
              std::get<SphereEstimate>(then->targets[0].estimate).mean);
    EXPECT_EQ(std::get<SphereEstimate>(now->targets[0].estimate).existenceProbability,
              std::get<SphereEstimate>(then->targets[0].estimate).existenceProbability);
    EXPECT_TRUE(sameTail(now->targets[0].tailPositions, then->targets[0].tailPositions));
    // A place of the tail is one where the target was held.
    EXPECT_EQ(now->targets[0].tailPositions.back().allFinite(),
              std::get<SphereEstimate>(now->targets[0].estimate).isValid);
    EXPECT_EQ(now->targets[0].status, then->targets[0].status);
    EXPECT_EQ(now->targets[0].positionCandidates.size(),
              then->targets[0].positionCandidates.size());
    const auto particles = now->targets[0].particles.rows();
    EXPECT_TRUE(particles == 0 || particles == then->targets[0].particles.rows());
    if (particles > 0) { // kept as floats: 24 bits of about a meter
      EXPECT_LT((now->targets[0].particles - then->targets[0].particles).abs().maxCoeff(), 1e-6);
    }
    EXPECT_LE(now->history.memoryBytes, now->history.maxMemoryBytes + (std::size_t{1} << 20));
  }
  session.returnToNewestFrame();
  ASSERT_TRUE(shows(session, kTravelFrames - 1));
  EXPECT_FALSE(session.newest()->isPast);
  EXPECT_EQ(session.trajectory().samples.size(),
            std::size_t{kTravelFrames}); // looking changes nothing
}

TEST_P(TimeTravelTest, ARerunWithNothingChangedGivesTheSameBits) {
  Session session(inputs());
  const Trajectory first = playedToTheEnd(session);
  for (const std::int64_t from : {70, 33, 1, 0, 89, 47}) {
    rerun(session, from);
    EXPECT_TRUE(sameBits(session.trajectory(), first)) << from;
    EXPECT_EQ(session.trajectory().header.entries, first.header.entries);
  }
}

TEST_P(TimeTravelTest, AChangedParameterHoldsFromTheFrameOn) {
  Session session(inputs());
  const Trajectory first = playedToTheEnd(session);
  ParameterValues changed = drawnInputs(GetParam().first, 1).project.parameters;
  const bool own = changed.set("acceleration_sigma", 2.0).has_value(); // barrera has none
  ASSERT_TRUE(own || changed.set("particles", 333.0));
  session.showFrame(37);
  session.setParameters(changed);
  rerun(session, 37);
  const Trajectory again = session.trajectory();
  EXPECT_TRUE(sameBits(until(again, 37), until(first, 37)));
  EXPECT_FALSE(sameBits(again, first));
  ASSERT_FALSE(again.header.entries.empty());
  EXPECT_EQ(again.header.entries.back().first, "changed_at_frame_37");
  EXPECT_EQ(again.header.entries.back().second, own ? "acceleration_sigma = 2" : "particles = 333");

  // The same as if it had been changed then.
  Session other(inputs());
  for (std::int64_t frame = 0; frame < 37; ++frame) {
    other.stepFrame();
  }
  other.setParameters(changed);
  EXPECT_TRUE(sameBits(playedToTheEnd(other), again));

  // And back: the run is what it was, and says so.
  session.setParameters(drawnInputs(GetParam().first, 1).project.parameters);
  rerun(session, 20);
  EXPECT_TRUE(sameBits(session.trajectory(), first));
  ASSERT_TRUE(reaches(session, PlayState::Ended));
  EXPECT_EQ(session.trajectory().header.entries, first.header.entries);
}

TEST_P(TimeTravelTest, PlayingFromAMomentShowsWhatWasRecorded) {
  Session session(inputs());
  const Trajectory first = playedToTheEnd(session);
  session.showFrame(80);
  ASSERT_TRUE(shows(session, 80));
  session.play();
  ASSERT_TRUE(reaches(session, PlayState::Ended));
  EXPECT_EQ(session.newest()->frame, kTravelFrames - 1);
  EXPECT_TRUE(sameBits(session.trajectory(), first));
  session.showFrame(80);
  session.stepFrame();
  ASSERT_TRUE(shows(session, 81));
  EXPECT_EQ(session.newest()->state, PlayState::Paused);
}

TEST(TimeTravelOfColors, RangesThatFollowTheLightAreHeldByTheCopies) {
  const auto inputs = [] {
    SessionInputs result = drawnInputs("dewpoint", kTravelFrames);
    result.source = std::make_unique<FadingRecording>(kTravelFrames);
    result.maxHistoryBytes = std::size_t{100} << 20;
    EXPECT_TRUE(result.project.parameters.set("color_adaptation", 0.5));
    return result;
  };
  Session session(inputs());
  session.setMasksShown(true);
  const Trajectory first = playedToTheEnd(session);
  session.showFrame(80);
  ASSERT_TRUE(shows(session, 80));
  const std::vector<ColorRanges> then =
      std::get<SphereEstimate>(session.newest()->targets[0].estimate).colors;
  ASSERT_EQ(then.size(), 2U);
  EXPECT_LT(then[0][0].intensityMax, 0.9 * drawn::kRed.intensityMax);
  for (const std::int64_t from : {70, 41, 12, 0}) {
    rerun(session, from);
    EXPECT_TRUE(sameBits(session.trajectory(), first)) << from;
    session.showFrame(80);
    ASSERT_TRUE(shows(session, 80));
    EXPECT_EQ(std::get<SphereEstimate>(session.newest()->targets[0].estimate).colors, then) << from;
  }
  // Without it the run is another one.
  ParameterValues off = inputs().project.parameters;
  ASSERT_TRUE(off.set("color_adaptation", 0.0));
  session.setParameters(off);
  rerun(session, 30);
  session.showFrame(80);
  ASSERT_TRUE(shows(session, 80));
  EXPECT_TRUE(std::get<SphereEstimate>(session.newest()->targets[0].estimate).colors.empty());
}

INSTANTIATE_TEST_SUITE_P(Methods, TimeTravelTest,
                         testing::Values(Case{"barrera", std::size_t{100} << 20},
                                         Case{"dewpoint", std::size_t{100} << 20},
                                         Case{"barrera", std::size_t{1} << 19},
                                         Case{"dewpoint", std::size_t{3} << 20}),
                         [](const auto& test) {
                           return std::string(test.param.first) +
                                  (test.param.second < (std::size_t{50} << 20) ? "Small" : "");
                         });

TEST(TimeTravel, APreviewStandsInWhileImagesAreDecoded) {
  SessionInputs inputs = drawnInputs("barrera", kTravelFrames);
  inputs.maxHistoryBytes = std::size_t{2} << 20; // 512 KB for images: one frame set, and small ones
  Session session(std::move(inputs));
  playedToTheEnd(session);
  for (std::int64_t frame = 5; frame < 80; frame += 25) {
    session.showFrame(frame);
    ASSERT_TRUE(shows(session, frame));
    EXPECT_TRUE(samePixels(*session.newest()->frames, *DrawnRecording::frame(frame)));
  }
  EXPECT_LE(session.newest()->history.memoryBytes,
            session.newest()->history.maxMemoryBytes + (1U << 20));
}

TEST(TimeTravel, AnUntrackedPartIsShownAndTrackedFrom) {
  Session session(drawnInputs("dewpoint", kTravelFrames));
  session.showFrame(50);
  ASSERT_TRUE(shows(session, 50));
  EXPECT_FALSE(session.newest()->isTracked);
  EXPECT_TRUE(session.newest()->isPast);
  EXPECT_TRUE(samePixels(*session.newest()->frames, *DrawnRecording::frame(50)));
  EXPECT_EQ(session.newest()->targets.at(0).particles.rows(), 0);
  const Trajectory played = playedToTheEnd(session);
  ASSERT_EQ(played.samples.size(), std::size_t{kTravelFrames - 50});
  EXPECT_EQ(played.samples.front().frame, 50);
  EXPECT_LT((played.samples.back().position - DrawnRecording::ballAt(kTravelFrames - 1)).norm(),
            0.01);
}

TEST(TimeTravel, AnotherMethodBeginsAtTheFrame) {
  Session session(drawnInputs("dewpoint", kTravelFrames));
  const Trajectory first = playedToTheEnd(session);
  session.setMethodFrom(60, "barrera", drawn::parametersOf("barrera"));
  ASSERT_TRUE(eventually([&] {
    const auto snapshot = session.newest();
    return snapshot->state == PlayState::Ended && !snapshot->rerun &&
           snapshot->targets.size() == 1 &&
           snapshot->targets[0].positionCandidates.empty(); // barrera makes none
  }));
  const Trajectory again = session.trajectory();
  EXPECT_EQ(again.samples.size(), first.samples.size());
  EXPECT_TRUE(sameBits(until(again, 60), until(first, 60)));
  EXPECT_TRUE(again.header.entries.back().second.starts_with("method = barrera; "));
}

/// Two reruns in a row, the second one while the first is under way.
class TimeTravelTwiceTest : public ::testing::TestWithParam<std::pair<int, int>> {};

TEST_P(TimeTravelTwiceTest, AfterARerunDuringARerunTheRunStandsWhereItStood) {
  constexpr std::int64_t kStood = 24;
  Session session(drawnInputs("dewpoint", kTravelFrames));
  for (std::int64_t k = 0; k <= kStood; ++k) {
    session.stepFrame();
  }
  ASSERT_TRUE(eventually([&] { return session.newest()->history.newestTrackedFrame == kStood; }));
  const Trajectory first = session.trajectory();
  session.rerunFrom(GetParam().first);
  session.rerunFrom(GetParam().second);
  session.setMasksShown(true); // in their order: both have begun when there are masks
  ASSERT_TRUE(eventually([&] {
    const auto snapshot = session.newest();
    return !snapshot->masks.empty() && !snapshot->rerun &&
           snapshot->history.newestTrackedFrame >= kStood;
  }));
  EXPECT_EQ(session.newest()->state, PlayState::Paused);
  EXPECT_EQ(session.newest()->history.newestTrackedFrame, kStood);
  EXPECT_EQ(session.trajectory().samples.size(), first.samples.size());
  EXPECT_TRUE(sameBits(session.trajectory(), first));
}

INSTANTIATE_TEST_SUITE_P(Orders, TimeTravelTwiceTest,
                         testing::Values(std::pair(16, 8), std::pair(8, 16), std::pair(8, 8)));

TEST(TimeTravel, MasksAndLikelihoodMapsOfAPastMoment) {
  Session session(drawnInputs("dewpoint", kTravelFrames));
  playedToTheEnd(session);
  session.setMasksShown(true);
  session.setLikelihoodMapsShown(true);
  session.showFrame(44);
  ASSERT_TRUE(eventually([&] {
    const auto snapshot = session.newest();
    return snapshot->frame == 44 && !snapshot->targets.at(0).maps.empty();
  }));
  const auto snapshot = session.newest();
  ASSERT_EQ(snapshot->masks.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_GT(cv::countNonZero(snapshot->masks[k]), 100);
    const LikelihoodMap& map = snapshot->targets[0].maps[k];
    const Eigen::Vector2d ball =
        Projector(DrawnRecording::rig()[k]).project(DrawnRecording::ballAt(44)).value();
    ASSERT_TRUE(map.area.contains(cv::Point(cvRound(ball.x()), cvRound(ball.y()))));
    ASSERT_EQ(map.logLikelihood.size(), map.area.size());
    double most = 0.0;
    cv::Point place;
    cv::minMaxLoc(map.logLikelihood, nullptr, &most, nullptr, &place);
    // Samples of a disc of about ten pixels are all within it for some pixels around its middle.
    EXPECT_NEAR(place.x + map.area.x, ball.x(), 3.0);
    EXPECT_NEAR(place.y + map.area.y, ball.y(), 3.0);
    EXPECT_NEAR(most, map.maxLogLikelihood, 1e-4);
    EXPECT_LT(map.logLikelihood.at<float>(0, 0), 0.0F); // the wall
  }
}

TEST(TimeTravel, ALiveRunIsRerunOverItsLastFrames) {
  SessionInputs live = drawnInputs("dewpoint", kTravelFrames, true);
  live.maxHistoryBytes = std::size_t{200}
                         << 20; // everything fits as it came: 90 x 2 x 230 KB = 41 MB
  Session session(std::move(live));
  session.play();
  ASSERT_TRUE(eventually(
      [&] { return session.newest()->history.newestTrackedFrame == kTravelFrames - 1; }));
  const Trajectory first = session.trajectory();
  session.showFrame(30);
  ASSERT_TRUE(shows(session, 30));
  EXPECT_EQ(session.newest()->frames->frames[1], nullptr); // the camera was lost
  EXPECT_EQ(session.newest()->state, PlayState::Paused);
  rerun(session, 25);
  EXPECT_TRUE(sameBits(session.trajectory(), first));
  session.play();
  ASSERT_TRUE(reaches(session, PlayState::Playing));
}

TEST(TimeTravel, ALiveRunKeepsWithinItsMemory) {
  SessionInputs live = drawnInputs("dewpoint", 400, true);
  live.maxHistoryBytes = std::size_t{8} << 20;
  Session session(std::move(live));
  session.play();
  ASSERT_TRUE(eventually([&] { return session.newest()->history.newestTrackedFrame == 399; }));
  const HistoryState state = session.newest()->history;
  EXPECT_GT(state.firstFrame, 0); // 400 x 2 x 230 KB = 184 MB would not fit
  EXPECT_LE(state.memoryBytes, state.maxMemoryBytes + (std::size_t{1} << 20));
  session.showFrame(0); // gone: the oldest there is
  ASSERT_TRUE(shows(session, state.firstFrame));
  const auto picture = session.newest()->frames->frames[0];
  ASSERT_NE(picture, nullptr);
  const auto truth = DrawnRecording::frame(state.firstFrame)->frames[0];
  EXPECT_EQ(picture->captureTime, truth->captureTime);
  // Noise of 3 gray levels, some of which JPEG takes for itself.
  EXPECT_LT(cv::norm(picture->image, truth->image, cv::NORM_L1) /
                static_cast<double>(truth->image.total() * 3),
            4.0);
}

TEST(TimeTravel, TheFrameLogTellsStatusReasonsAndMissingCameras) {
  Session session(drawnInputs("dewpoint", kTravelFrames));
  playedToTheEnd(session);
  std::uint64_t generation = 0;
  std::size_t position = 0;
  auto piece = session.framesSince(generation, position);
  EXPECT_TRUE(piece.restarted);
  ASSERT_EQ(piece.records.size(), std::size_t{kTravelFrames});
  for (const FrameRecord& record : piece.records) {
    const bool lost = record.frame % 40 >= 30 && record.frame % 40 < 33;
    EXPECT_EQ(record.missingCameraBits, lost ? 2U : 0U) << record.frame; // bit 1
    ASSERT_EQ(record.targets.size(), 1U);
    EXPECT_DOUBLE_EQ(record.time, seconds(timeStamp(static_cast<double>(record.frame) / 30.0)));
  }
  EXPECT_EQ(piece.records[20].targets[0].status, TargetStatus::Held);
  EXPECT_GT(piece.records[20].targets[0].existenceProbability, 0.9F);
  EXPECT_TRUE(piece.records[20].targets[0].cameraReports.empty());
  session.rerunFrom(80);
  ASSERT_TRUE(eventually([&] {
    piece = session.framesSince(generation, position);
    return piece.restarted;
  }));
}

} // namespace
} // namespace dewpoint::tests
