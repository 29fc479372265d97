// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/barrera/dynamics_parameters.h"
#include "core/tracking/barrera/dynamics_tracker.h"
#include "tests/tracking/drawn_run.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

ParameterValues startingAt(const Eigen::Vector3d& start) {
  ParameterValues parameters(dynamicsParameters());
  EXPECT_TRUE(parameters.set("start_x", start.x()));
  EXPECT_TRUE(parameters.set("start_y", start.y()));
  EXPECT_TRUE(parameters.set("start_z", start.z()));
  return parameters;
}

TEST(DynamicsTracker, MeasuresWhereTheColorsMassIs) {
  const CameraRig rig = drawn::rigAround(3);
  DynamicsTracker tracker(startingAt(drawn::kMiddle), rig, drawn::redBall());
  const Eigen::Vector3d ball = drawn::kMiddle + Eigen::Vector3d(0.05, -0.04, 0.03);
  tracker.restart(1);
  tracker.beginFrame(drawn::framesOf(rig, {{ball}}, 0));
  ASSERT_TRUE(tracker.measuredPosition());
  // Disks of about 20 pixels: their centers of mass are good to a tenth of a pixel, 1 mm is 0.5.
  EXPECT_LT((*tracker.measuredPosition() - ball).norm(), 0.002);
  ThreadTeam team(1);
  const SphereEstimate estimate = tracker.iterate(team);
  EXPECT_TRUE(estimate.isValid);
  EXPECT_EQ(estimate.seeingCameraCount, 3);
  EXPECT_EQ(tracker.cameraReports().front().status, CameraStatus::None);
}

TEST(DynamicsTracker, WhatIsOutsideTheVolumeOfInterestIsNoMeasurement) {
  const CameraRig rig = drawn::rigAround(3);
  DynamicsTracker tracker(startingAt(drawn::kMiddle), rig, drawn::redBall());
  tracker.setVolumeOfInterest(WorldBox{drawn::kMiddle + Eigen::Vector3d(0.1, -1.0, -1.0),
                                       drawn::kMiddle + Eigen::Vector3d(1.0, 1.0, 1.0)});
  tracker.restart(1);
  tracker.beginFrame(drawn::framesOf(rig, {{drawn::kMiddle}}, 0));
  EXPECT_FALSE(tracker.measuredPosition());
  ThreadTeam team(1);
  EXPECT_FALSE(tracker.iterate(team).isValid);
  tracker.beginFrame(drawn::framesOf(rig, {{drawn::kMiddle + Eigen::Vector3d(0.15, 0.0, 0.0)}}, 1));
  EXPECT_TRUE(tracker.measuredPosition());
  EXPECT_TRUE(tracker.iterate(team).isValid);
}

TEST(DynamicsTracker, OneCameraAloneMeasuresNothing) {
  const CameraRig rig = drawn::rigAround(1);
  DynamicsTracker tracker(startingAt(drawn::kMiddle), rig, drawn::redBall());
  tracker.restart(1);
  tracker.beginFrame(drawn::framesOf(rig, {{drawn::kMiddle}}, 0));
  EXPECT_FALSE(tracker.measuredPosition());
  ThreadTeam team(1);
  EXPECT_FALSE(tracker.iterate(team).isValid);
  tracker.beginFrame(drawn::framesOf(rig, {}, 1));
  EXPECT_EQ(tracker.cameraReports().front().status, CameraStatus::NoColor);
}

TEST(DynamicsTracker, FollowsGivenPositionsAndSpreadsWithout) {
  DynamicsTracker tracker(startingAt({0.0, 0.0, 0.0}), {}, {});
  tracker.restart(7);
  ThreadTeam team(1);
  const Eigen::Vector3d place(0.2, 0.1, 0.0);
  SphereEstimate estimate;
  for (int k = 0; k < 40; ++k) {
    tracker.beginFrame(k, place);
    estimate = tracker.iterate(team);
  }
  // The steady spread s of a random walk under a Gaussian: s^2 = (s^2 + m^2) o^2 / (s^2 + m^2 +
  // o^2) with m = 0.03, o = 0.1 per axis: s = 0.0505; the mean of about 150 such particles.
  EXPECT_LT((estimate.mean - place).norm(), 4.0 * 0.0505 * std::sqrt(3.0 / 150.0));
  EXPECT_NEAR(estimate.spread(), 0.0505 * std::sqrt(3.0), 0.02);
  const double before = estimate.spread();
  for (int k = 40; k < 60; ++k) {
    tracker.beginFrame(k, std::nullopt);
    estimate = tracker.iterate(team);
  }
  EXPECT_FALSE(estimate.isValid);
  EXPECT_GT(estimate.spread(), before);
}

TEST(DynamicsTracker, AFarMeasurementDoesNotUnderflow) {
  DynamicsTracker tracker(startingAt({0.0, 0.0, 0.0}), {}, {});
  tracker.restart(7);
  ThreadTeam team(1);
  tracker.beginFrame(0, Eigen::Vector3d(50.0, 0.0, 0.0)); // exp(-125000) as a plain number
  const SphereEstimate estimate = tracker.iterate(team);
  EXPECT_FALSE(estimate.isDegenerate);
  EXPECT_GT(estimate.mean.x(), 0.0) << "those nearer to it count more";
}

} // namespace
} // namespace dewpoint::tests
