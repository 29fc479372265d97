// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/backward_track.h"
#include "tests/session/drawn_recording.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dewpoint::tests {
namespace {

using test::drawnInputs;
using test::DrawnRecording;

constexpr std::int64_t kBackwardFrames = 60;
constexpr std::int64_t kSaidAt = 45;

PositionCorrection saidAt(std::int64_t frame) {
  PositionCorrection correction;
  correction.frame = frame;
  correction.position = DrawnRecording::ballAt(frame);
  correction.covariance *= 1e-4;
  return correction;
}

bool keepsGoing(double /*done*/) {
  return true;
}

class BackwardTracking : public testing::TestWithParam<const char*> {
protected:
  BackwardTracking() : inputs_(drawnInputs(GetParam(), kBackwardFrames)) {
    inputs_.project.corrections = {saidAt(kSaidAt)};
  }
  /// As if the run had believed that it is elsewhere in these frames.
  BackwardRequest wrongFrom(std::int64_t first) const {
    BackwardRequest order{RunDefinition::fromProject(inputs_.project), saidAt(kSaidAt), {}};
    for (std::int64_t frame = 0; frame <= kSaidAt; ++frame) {
      TrajectorySample sample;
      sample.frame = frame;
      sample.target = inputs_.project.targets[0].name;
      sample.position = DrawnRecording::ballAt(frame);
      sample.position.z() += frame < first ? 0.0 : 0.3;
      sample.covariance = 1e-4 * Eigen::Matrix3d::Identity();
      order.estimates.push_back(sample);
    }
    return order;
  }
  std::vector<PositionCorrection> found(const BackwardRequest& order) {
    auto result = trackBackwards(*inputs_.source, order, 1, keepsGoing);
    EXPECT_TRUE(result);
    return result ? *result : std::vector<PositionCorrection>();
  }

  SessionInputs inputs_;
};

TEST_P(BackwardTracking, FindsWhereTheTargetWas) {
  const auto corrections = found(wrongFrom(0));
  ASSERT_GE(corrections.size(), 2U);
  EXPECT_EQ(corrections.front().frame, 0);
  for (const PositionCorrection& one : corrections) {
    EXPECT_EQ(one.trackedFrom, kSaidAt);
    EXPECT_LT(one.frame, kSaidAt);
    EXPECT_LT((one.position - DrawnRecording::ballAt(one.frame)).norm(), 0.02) << one.frame;
  }
  Project project = inputs_.project;
  for (const PositionCorrection& one : corrections) {
    addCorrection(project, one);
  }
  EXPECT_EQ(project.corrections.size(), corrections.size() + 1);
}

TEST_P(BackwardTracking, EndsWhereWhatWasBelievedIsRight) {
  const auto corrections = found(wrongFrom(20));
  ASSERT_FALSE(corrections.empty());
  EXPECT_NEAR(static_cast<double>(corrections.front().frame), 20.0, 2.0);
  EXPECT_TRUE(found(wrongFrom(kBackwardFrames)).empty());
}

// What was believed may be right for some time, and wrong once more before.
TEST_P(BackwardTracking, MendsWhatWasWrongBeforeItWasRight) {
  BackwardRequest order = wrongFrom(0);
  for (TrajectorySample& sample : order.estimates) {
    sample.position.z() -= sample.frame >= 20 ? 0.3 : 0.0;
  }
  const auto corrections = found(order);
  ASSERT_FALSE(corrections.empty());
  EXPECT_EQ(corrections.front().frame, 0);
  EXPECT_LT(corrections.back().frame, 22);
}

/// A ball that is elsewhere, and was not seen to go there, before a frame.
class JumpingRecording final : public FrameSetSource {
public:
  static constexpr std::int64_t kJump = 20;
  std::optional<std::int64_t> frameCount() const override { return kBackwardFrames; }
  double framesPerSecond() const override { return 30.0; }
  Result<FrameSetPtr> next() override {
    const std::int64_t shown = next_ < kJump ? next_ + kBackwardFrames : next_;
    return tests::drawn::framesOf(DrawnRecording::rig(), {{DrawnRecording::ballAt(shown)}},
                                  next_++);
  }
  Status seek(std::int64_t frame) override {
    next_ = frame;
    return {};
  }

private:
  std::int64_t next_ = 0;
};

// Where the two part, what was believed goes on evenly: the track back has gone to something else.
TEST_P(BackwardTracking, EndsWhereItJumpsAwayFromWhatWasBelieved) {
  JumpingRecording recording;
  const auto corrections = trackBackwards(recording, wrongFrom(kBackwardFrames), 1, keepsGoing);
  ASSERT_TRUE(corrections);
  EXPECT_TRUE(corrections->empty());
}

TEST_P(BackwardTracking, EndsAtWhatAPersonSaidBefore) {
  BackwardRequest order = wrongFrom(0);
  order.definition.corrections = {saidAt(25), saidAt(kSaidAt)};
  const auto corrections = found(order);
  ASSERT_FALSE(corrections.empty());
  EXPECT_EQ(corrections.front().frame, 26);
}

TEST_P(BackwardTracking, HasTheSameBitsForAnyNumberOfThreads) {
  const BackwardRequest order = wrongFrom(10);
  const auto three = trackBackwards(*inputs_.source, order, 3, keepsGoing);
  ASSERT_TRUE(three);
  EXPECT_EQ(*three, found(order));
}

TEST_P(BackwardTracking, IsOfRecordingsAndCanBeCanceled) {
  SessionInputs live = drawnInputs(GetParam(), kBackwardFrames, true);
  const auto nothing = trackBackwards(*live.source, wrongFrom(0), 1, keepsGoing);
  ASSERT_TRUE(nothing);
  EXPECT_TRUE(nothing->empty());
  int calls = 0;
  const auto stopped =
      trackBackwards(*inputs_.source, wrongFrom(0), 1, [&](double) { return ++calls < 10; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::Canceled);
  EXPECT_EQ(calls, 10);
}

// The run itself believes what is right: nothing is to be mended, and what was found for an earlier
// state of the project goes.
TEST_P(BackwardTracking, OfAProjectReplacesWhatWasFoundBefore) {
  Project stale = inputs_.project;
  PositionCorrection old = saidAt(30);
  old.trackedFrom = kSaidAt;
  addCorrection(stale, old);
  const auto project = withBackwardCorrections(stale, *inputs_.source, {}, 1, keepsGoing);
  ASSERT_TRUE(project);
  EXPECT_EQ(project->corrections, inputs_.project.corrections);
}

INSTANTIATE_TEST_SUITE_P(Methods, BackwardTracking, testing::Values("dewpoint", "barrera"),
                         [](const auto& method) { return std::string(method.param); });

} // namespace
} // namespace dewpoint::tests
