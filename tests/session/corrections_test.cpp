// SPDX-License-Identifier: GPL-3.0-or-later
// Corrections of positions in a run: the same bits whichever way a frame is reached.
#include "core/base/text_file.h"
#include "core/session/run/frame_loop.h"
#include "core/trajectory/trajectory_reader.h"
#include "tests/session/drawn_recording.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>

namespace dewpoint::tests {
namespace {

using test::drawnInputs;
using test::DrawnRecording;
using test::eventually;
using test::reaches;
using test::sameBits;

constexpr std::int64_t kCorrectedFrames = 40;

/// The target is 15 mm beside the ball at this frame, with a standard deviation of 10 mm.
PositionCorrection beside(std::int64_t frame) {
  PositionCorrection correction;
  correction.frame = frame;
  correction.position = DrawnRecording::ballAt(frame) + Eigen::Vector3d(0.015, 0.0, 0.0);
  correction.covariance *= 1e-4;
  correction.clicks = {{1, {100.0, 80.5}}};
  return correction;
}

const std::vector<PositionCorrection> kTwo{beside(15), beside(22)};

std::vector<std::int64_t> correctedFrames(const Trajectory& trajectory) {
  std::vector<std::int64_t> frames;
  for (const TrajectorySample& sample : trajectory.samples) {
    if (sample.isCorrected) {
      frames.push_back(sample.frame);
    }
  }
  return frames;
}

class CorrectionsOfARun : public testing::TestWithParam<const char*> {
protected:
  static SessionInputs inputs(std::vector<PositionCorrection> corrections = {}) {
    SessionInputs result = drawnInputs(GetParam(), kCorrectedFrames);
    result.project.corrections = std::move(corrections);
    return result;
  }
  static Trajectory played(Session& session) {
    session.play();
    EXPECT_TRUE(reaches(session, PlayState::Ended));
    return session.trajectory();
  }
  static Trajectory playedWith(std::vector<PositionCorrection> corrections) {
    Session session(inputs(std::move(corrections)));
    return played(session);
  }
  /// Waits until the frames that other corrections change were tracked again, to the end.
  static bool isTrackedAgain(Session& session, std::uint64_t& generation, std::size_t& position) {
    return eventually([&] { return session.framesSince(generation, position).restarted; }) &&
           eventually([&] {
             const auto shown = session.newest();
             return !shown->rerun && shown->state == PlayState::Ended &&
                    session.trajectory().samples.size() == kCorrectedFrames;
           });
  }
  static Trajectory corrected(Session& session,
                              const std::vector<PositionCorrection>& corrections) {
    std::uint64_t generation = 0;
    std::size_t position = 0;
    session.framesSince(generation, position);
    session.setCorrections(corrections);
    EXPECT_TRUE(isTrackedAgain(session, generation, position));
    return session.trajectory();
  }
  static Trajectory trackedAgain(Session& session, std::int64_t from) {
    std::uint64_t generation = 0;
    std::size_t position = 0;
    session.framesSince(generation, position);
    session.rerunFrom(from);
    EXPECT_TRUE(isTrackedAgain(session, generation, position));
    return session.trajectory();
  }
};

TEST_P(CorrectionsOfARun, HoldFromTheirFramesOn) {
  const Trajectory without = playedWith({});
  const Trajectory with = playedWith(kTwo);
  ASSERT_EQ(with.samples.size(), std::size_t{kCorrectedFrames});
  EXPECT_TRUE(correctedFrames(without).empty());
  EXPECT_EQ(correctedFrames(with), (std::vector<std::int64_t>{15, 22}));
  EXPECT_FALSE(without.header.hasCorrectedColumn);
  EXPECT_TRUE(with.header.hasCorrectedColumn);
  for (std::size_t k = 0; k < 15; ++k) {
    ASSERT_EQ(with.samples[k].position, without.samples[k].position) << k;
  }
  EXPECT_NE(with.samples[15].position, without.samples[15].position);
  EXPECT_LT((with.samples[15].position - beside(15).position).norm(), 0.03);
  EXPECT_TRUE(with.samples[15].isValid);
}

TEST_P(CorrectionsOfARun, AreMadeAndUndoneAfterwards) {
  const Trajectory without = playedWith({});
  const Trajectory one = playedWith({kTwo[1]});
  const Trajectory both = playedWith(kTwo);
  EXPECT_FALSE(sameBits(one, without));
  EXPECT_FALSE(sameBits(one, both));
  Session session(inputs());
  played(session);
  EXPECT_TRUE(sameBits(corrected(session, {kTwo[1]}), one));
  EXPECT_TRUE(sameBits(corrected(session, kTwo), both));
  EXPECT_EQ(correctedFrames(session.trajectory()), (std::vector<std::int64_t>{15, 22}));
  EXPECT_TRUE(session.trajectory().header.hasCorrectedColumn);
  for (const std::int64_t from : {0, 10, 15, 16, 30}) {
    EXPECT_TRUE(sameBits(trackedAgain(session, from), both)) << from;
  }
  EXPECT_TRUE(sameBits(corrected(session, {kTwo[1]}), one));
  EXPECT_TRUE(sameBits(corrected(session, {}), without));
  EXPECT_FALSE(session.trajectory().header.hasCorrectedColumn);
  EXPECT_TRUE(correctedFrames(session.trajectory()).empty());
}

// The frame that the run stands at is not tracked again.
TEST_P(CorrectionsOfARun, AreMadeAtTheFrameTheRunStandsAt) {
  const Trajectory both = playedWith(kTwo);
  Session session(inputs());
  std::vector<PositionCorrection> corrections;
  for (std::int64_t frame = 0; frame <= 22; ++frame) {
    session.stepFrame();
    ASSERT_TRUE(eventually([&] { return session.newest()->history.newestTrackedFrame == frame; }));
    if (frame == 15 || frame == 22) {
      corrections.push_back(beside(frame));
      session.setCorrections(corrections);
      ASSERT_TRUE(eventually([&] { return session.trajectory().samples.back().isCorrected; }));
    }
  }
  EXPECT_TRUE(sameBits(played(session), both));
  EXPECT_TRUE(sameBits(trackedAgain(session, 18), both)); // from a copy before the second one
  EXPECT_TRUE(sameBits(trackedAgain(session, 3), both));
}

// As they are dragged on, the last one counts.
TEST_P(CorrectionsOfARun, TakeThePlaceOfFormerOnesOfTheirFrame) {
  Session session(inputs());
  for (std::int64_t frame = 0; frame <= 15; ++frame) {
    session.stepFrame();
  }
  ASSERT_TRUE(eventually([&] { return session.newest()->history.newestTrackedFrame == 15; }));
  PositionCorrection rough = beside(15);
  rough.position.z() += 0.02;
  std::uint64_t generation = 0;
  std::size_t position = 0;
  session.framesSince(generation, position);
  session.setCorrections({rough});
  session.setCorrections(kTwo);
  ASSERT_TRUE(eventually([&] { return session.framesSince(generation, position).restarted; }));
  ASSERT_TRUE(eventually([&] {
    const auto shown = session.newest();
    return !shown->rerun && shown->isTracked && session.trajectory().samples.size() == 16;
  }));
  EXPECT_TRUE(sameBits(played(session), playedWith(kTwo)));
}

TEST_P(CorrectionsOfARun, AreThoseOfTheCommandLine) {
  class Samples final : public FrameObserver {
  public:
    Status onFrameTracked(const TrackingRun& run) override {
      std::ranges::copy(run.samples(), std::back_inserter(trajectory.samples));
      return {};
    }
    Trajectory trajectory;
  } samples;
  SessionInputs recording = inputs(kTwo);
  auto run = TrackingRun::create(recording.project, 3).value();
  const std::array<FrameObserver*, 1> observers{&samples};
  ASSERT_TRUE(trackFrames(*recording.source, {}, run, observers, [] { return true; }));
  EXPECT_TRUE(sameBits(samples.trajectory, playedWith(kTwo)));
  EXPECT_EQ(correctedFrames(samples.trajectory), (std::vector<std::int64_t>{15, 22}));
}

TEST_P(CorrectionsOfARun, OfTargetsThatAreNotThereChangeNothing) {
  PositionCorrection other = beside(15);
  other.target = 1;
  EXPECT_TRUE(sameBits(playedWith({other}), playedWith({})));
}

TEST_P(CorrectionsOfARun, AreInWhatItLeaves) {
  SessionInputs named = inputs(kTwo);
  named.project.cameras[1].camera.name = "second";
  Session session(std::move(named));
  played(session);
  const auto folder = std::filesystem::path(testing::TempDir()) / "corrections" / GetParam();
  ASSERT_TRUE(session.saveRun(folder));
  const auto report = nlohmann::json::parse(readTextFile(folder / "run.json").value());
  ASSERT_EQ(report["corrections"].size(), 2U);
  const auto& second = report["corrections"][1];
  EXPECT_EQ(second["target"], "ball");
  EXPECT_EQ(second["frame"], 22);
  EXPECT_EQ(second["position"][2], beside(22).position.z());
  EXPECT_NEAR(second["sigma"][0].get<double>(), 0.01, 1e-12);
  EXPECT_EQ(second["clicks"][0]["camera"], "second");
  EXPECT_EQ(second["clicks"][0]["pixel"][1], 80.5);
  const auto trajectory = readTrajectory(folder / "trajectory.csv");
  ASSERT_TRUE(trajectory) << errorSentence(trajectory.error());
  EXPECT_EQ(correctedFrames(*trajectory), (std::vector<std::int64_t>{15, 22}));
}

INSTANTIATE_TEST_SUITE_P(Methods, CorrectionsOfARun, testing::Values("dewpoint", "barrera"));

} // namespace
} // namespace dewpoint::tests
