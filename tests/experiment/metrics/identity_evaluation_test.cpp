// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/identity_evaluation.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dewpoint::tests {
namespace {

TrajectorySample at(std::int64_t frame, const char* target, double x, double z = 0.0) {
  TrajectorySample sample;
  sample.frame = frame;
  sample.time = 0.1 * static_cast<double>(frame);
  sample.target = target;
  sample.position = {x, 0.0, z};
  return sample;
}

/// Two people who walk apart for four frames; the estimates change places after two of them.
void exchange(Trajectory& estimate, Trajectory& truth) {
  for (std::int64_t frame = 0; frame < 4; ++frame) {
    const double x = 1.0 + static_cast<double>(frame);
    truth.samples.push_back(at(frame, "left", -x));
    truth.samples.push_back(at(frame, "right", x));
    estimate.samples.push_back(at(frame, frame < 2 ? "person 1" : "person 2", -x, 0.9));
    estimate.samples.push_back(at(frame, frame < 2 ? "person 2" : "person 1", x + 0.1, 0.9));
  }
}

TEST(IdentityEvaluation, CountsSwitchesAndPlacesOnTheFloor) {
  Trajectory estimate;
  Trajectory truth;
  exchange(estimate, truth);
  const auto result = evaluateIdentities(estimate, truth, {0.5, true});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->frameCount, 4);
  EXPECT_EQ(result->clearMot.truthCount, 8);
  EXPECT_EQ(result->clearMot.matches, 8);
  EXPECT_EQ(result->clearMot.identitySwitches, 2);
  EXPECT_NEAR(result->clearMot.mota(), 1.0 - 2.0 / 8.0, 1e-12);
  EXPECT_NEAR(result->clearMot.motp(), 0.05, 1e-12); // 0 and 0.1 m
  // Each truth is half of its time with each estimate: TPA / (TPA + FNA + FPA) = 2 / 6.
  EXPECT_NEAR(result->hota.thresholds[0].associationAccuracy, 1.0 / 3.0, 1e-12);
  EXPECT_EQ(identityJson(*result)["identity_switches"], 2);
  EXPECT_NE(identityText(*result).find("2 switches"), std::string::npos);
}

TEST(IdentityEvaluation, WithHeightsNothingMatches) {
  Trajectory estimate;
  Trajectory truth;
  exchange(estimate, truth);
  const auto result = evaluateIdentities(estimate, truth, {0.5, false});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->clearMot.matches, 0); // 0.9 m apart
  EXPECT_EQ(result->clearMot.falsePositives, 8);
}

TEST(IdentityEvaluation, NotValidIsNotThere) {
  Trajectory estimate;
  Trajectory truth;
  exchange(estimate, truth);
  truth.samples[6].isValid = false; // "left" has left at the last frame
  const auto result = evaluateIdentities(estimate, truth, {0.5, true});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->clearMot.truthCount, 7);
  EXPECT_EQ(result->clearMot.falsePositives, 1);
}

TEST(IdentityEvaluation, NeedsCommonFrames) {
  Trajectory estimate;
  Trajectory truth;
  EXPECT_FALSE(evaluateIdentities(estimate, truth, {}));
  exchange(estimate, truth);
  for (auto& sample : estimate.samples) {
    sample.frame += 100;
  }
  const auto result = evaluateIdentities(estimate, truth, {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::Mismatch);
}

} // namespace
} // namespace dewpoint::tests
