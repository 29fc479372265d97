// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/truth_names.h"
#include "core/trajectory/evaluation.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

void add(Trajectory& trajectory, std::int64_t frame, const char* target, double x) {
  TrajectorySample sample;
  sample.frame = frame;
  sample.time = 0.1 * static_cast<double>(frame);
  sample.target = target;
  sample.position = {x, 0.0, 0.0};
  trajectory.samples.push_back(sample);
}

/// Two balls that stay 1 m apart for ten frames, under these names.
Trajectory twoBalls(const char* left, const char* right) {
  Trajectory trajectory;
  for (std::int64_t frame = 0; frame < 10; ++frame) {
    add(trajectory, frame, left, 0.0);
    add(trajectory, frame, right, 1.0);
  }
  return trajectory;
}

TEST(TruthNames, OfTargetsAlikeFollowThePositions) {
  const Trajectory truth = twoBalls("ball 1", "ball 2");
  const Trajectory estimate = twoBalls("ball 2", "ball 1");
  ASSERT_FALSE(evaluate(estimate, truth)->front().convergenceFrameCount); // by name
  const auto names = truthNamesByPosition(estimate, truth, {{"ball 1", "ball 2"}});
  EXPECT_EQ(names,
            (std::map<std::string, std::string>{{"ball 1", "ball 2"}, {"ball 2", "ball 1"}}));
  const auto compared = evaluate(estimate, withTrackedNames(truth, names));
  ASSERT_TRUE(compared);
  for (const Evaluation& one : *compared) {
    EXPECT_EQ(one.convergenceFrameCount, 0);
    EXPECT_EQ(one.rmse, 0.0);
  }
}

TEST(TruthNames, StayWhereTheyFitOrAreNotAlike) {
  const Trajectory truth = twoBalls("ball 1", "ball 2");
  EXPECT_TRUE(truthNamesByPosition(truth, truth, {{"ball 1", "ball 2"}}).empty());
  const Trajectory exchanged = twoBalls("ball 2", "ball 1");
  EXPECT_TRUE(truthNamesByPosition(exchanged, truth, {{"ball 1"}, {"ball 2"}}).empty());
}

TEST(TruthNames, StayWhereATargetIsMissing) {
  const Trajectory truth = twoBalls("ball 1", "ball 2");
  Trajectory estimate;
  add(estimate, 0, "ball 1", 1.0);
  EXPECT_TRUE(truthNamesByPosition(estimate, truth, {{"ball 1", "ball 2"}}).empty());
}

} // namespace
} // namespace dewpoint::tests
