// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/sensor/automatic_gain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dewpoint::tests {
namespace {

using namespace dewpoint::simulation;

TEST(ControlLoop, CancelsADisturbance) {
  // All of the error at once, one frame later.
  EXPECT_EQ(simulateControlLoop({1.0, 0, 0.0, 4.0}, std::vector<double>{1.0, 1.0, 1.0}, 0.0),
            (std::vector<double>{0.0, -1.0, -1.0}));
  // 0.2 per frame, seen two frames late: settles (0.2 < 2 sin(pi / 10) = 0.62) into its
  // deadband.
  const auto slow = simulateControlLoop({0.2, 2, 0.03, 4.0}, std::vector<double>(120, 1.0), 0.0);
  EXPECT_NEAR(slow[3], -0.6, 1e-12) << "three times the first error";
  EXPECT_NEAR(slow.back(), -1.0, 0.03);
  EXPECT_LT(*std::ranges::min_element(slow), -1.0) << "it overshoots";
}

TEST(ControlLoop, StaysWithinItsLimit) {
  const auto limited = simulateControlLoop({0.5, 1, 0.0, 1.5}, std::vector<double>(60, -4.0), 0.0);
  EXPECT_EQ(limited.back(), 1.5);
}

TEST(AutomaticGain, HasSettledBeforeTheRunButForItsError) {
  AutomaticGain control;
  control.initialExposureErrorStops = 0.5;
  control.whiteBalanceStops = {0.2, -0.1};
  const std::vector<Eigen::Vector3d> light(200, {1.5, 1.0, 1.0});
  const GainCurve curve = automaticGains(control, light, 30.0);
  // One stop too much light in green: half the exposure; blue is half a stop more than green.
  EXPECT_NEAR(curve.gainAt(0.0).exposureGain, std::exp2(-0.5), 1e-9);
  EXPECT_NEAR(curve.gainPerFrame.back().exposureGain, 0.5, 0.5 * 0.03);
  EXPECT_NEAR(curve.gainAt(0.0).whiteBalance[0], std::exp2(-0.3), 1e-9);
  EXPECT_NEAR(curve.gainAt(100.0).whiteBalance[2], std::exp2(-0.1), 1e-9);
  EXPECT_EQ(curve.gainAt(1.0).whiteBalance[1], 1.0);
}

TEST(AutomaticGain, FollowsTheLightSlowly) {
  AutomaticGain control;
  std::vector<Eigen::Vector3d> light(100, Eigen::Vector3d::Zero());
  for (std::size_t frame = 30; frame < light.size(); ++frame) {
    light[frame].setConstant(1.0);
  }
  const GainCurve curve = automaticGains(control, light, 30.0);
  EXPECT_EQ(curve.gainPerFrame[30].exposureGain, 1.0);
  EXPECT_EQ(curve.gainPerFrame[32].exposureGain, 1.0) << "two frames of lag";
  EXPECT_LT(curve.gainPerFrame[33].exposureGain, 1.0);
  EXPECT_GT(curve.gainPerFrame[36].exposureGain, 0.6);
  EXPECT_NEAR(curve.gainPerFrame[99].exposureGain, 0.5, 0.02);
  EXPECT_NEAR(curve.gainPerFrame[99].whiteBalance[0], 1.0, 1e-12) << "all channels alike: no tint";
}

TEST(AutomaticGain, HuntsWhenItsMeterIsMisled) {
  AutomaticGain control;
  control.huntingAmplitudeStops = 0.3;
  control.huntingPeriodSeconds = 4.0;
  control.exposureLoop.deadbandStops = 0.0;
  const GainCurve curve =
      automaticGains(control, std::vector<Eigen::Vector3d>(480, Eigen::Vector3d::Zero()), 30.0);
  double low = 1.0;
  double high = 1.0;
  for (std::size_t frame = 240; frame < 480; ++frame) {
    low = std::min(low, curve.gainPerFrame[frame].exposureGain);
    high = std::max(high, curve.gainPerFrame[frame].exposureGain);
  }
  // Slow against the loop's 7 frames: nearly the whole 0.3 stops to both sides.
  EXPECT_NEAR(std::log2(high), 0.3, 0.06);
  EXPECT_NEAR(std::log2(low), -0.3, 0.06);
}

TEST(GainCurve, WithoutFramesIsOne) {
  EXPECT_EQ(GainCurve().gainAt(3.0).exposureGain, 1.0);
}

} // namespace
} // namespace dewpoint::tests
