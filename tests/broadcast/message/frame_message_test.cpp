// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/message/frame_message.h"

#include <gtest/gtest.h>

#include <memory>

namespace dewpoint::tests {
namespace {

using broadcast::FrameMessage;
using broadcast::OutputCoordinates;
using broadcast::RecentPositions;

/// A camera on each side that looks at the origin.
std::shared_ptr<const CameraRig> twoCameras() {
  CameraRig rig(2);
  for (int k = 0; k < 2; ++k) {
    Camera& camera = rig[static_cast<std::size_t>(k)];
    camera.name = k == 0 ? "left" : "right";
    camera.intrinsics = {640, 480, 500.0, 500.0, 319.5, 239.5};
    camera.cameraFromWorld = lookAt({3.0, k == 0 ? -1.0 : 1.0, 1.0}, {0.0, 0.0, 0.0});
  }
  return std::make_shared<const CameraRig>(rig);
}

TrackSnapshot snapshotAt(std::int64_t frame, double time, const Eigen::Vector3d& position,
                         bool held = true) {
  TrackSnapshot snapshot;
  snapshot.rig = twoCameras();
  auto frames = std::make_shared<FrameSet>();
  frames->index = frame;
  frames->time = timeStamp(time);
  frames->frames = {std::make_shared<const Frame>(), std::make_shared<const Frame>()};
  snapshot.frames = frames;
  snapshot.frame = frame;
  snapshot.isTracked = true;
  TargetSnapshot& target = snapshot.targets.emplace_back();
  target.target.name = "ball";
  target.status = held ? TargetStatus::Held : TargetStatus::Searching;
  SphereEstimate sphere;
  sphere.mean = position;
  sphere.covariance = Eigen::Vector3d(1e-6, 4e-6, 9e-6).asDiagonal();
  sphere.isValid = held;
  sphere.particleCount = 100;
  sphere.existenceProbability = held ? 0.875 : 0.25;
  sphere.cameras.resize(2);
  sphere.cameras[0].isInView = sphere.cameras[1].isInView = true;
  sphere.cameras[0].visibleShare = 0.5; // hidden in the other one
  target.estimate = sphere;
  return snapshot;
}

FrameMessage messageOf(const TrackSnapshot& snapshot, const RecentPositions& recent,
                       const OutputCoordinates& coordinates = {}) {
  return frameMessageOf(snapshot, recent,
                        std::make_shared<const broadcast::RigMessage>(
                            rigMessageOf(snapshot, coordinates, std::nullopt)));
}

TEST(FrameMessage, HasEverythingThatIsKnownOfATarget) {
  RecentPositions recent;
  TrackSnapshot snapshot;
  for (int k = 0; k < 6; ++k) {
    snapshot = snapshotAt(k, 0.1 * k, {0.1 * k, 0.2, -0.02 * k});
    recent.add(snapshot);
  }
  const FrameMessage message = messageOf(snapshot, recent);
  EXPECT_EQ(message.frame, 5);
  EXPECT_DOUBLE_EQ(message.time, 0.5);
  ASSERT_EQ(message.targets.size(), 1U);
  const broadcast::TargetMessage& target = message.targets[0];
  EXPECT_EQ(target.id, 1);
  EXPECT_EQ(target.name, "ball");
  EXPECT_EQ(target.state, "held");
  ASSERT_TRUE(target.position);
  EXPECT_TRUE(target.position->isApprox(Eigen::Vector3d(0.5, 0.2, -0.1)));
  ASSERT_TRUE(target.velocity);
  EXPECT_TRUE(target.velocity->isApprox(Eigen::Vector3d(1.0, 0.0, -0.2), 1e-9));
  EXPECT_LT(target.acceleration.norm(), 1e-9);
  EXPECT_DOUBLE_EQ(target.covariance(2, 2), 9e-6);
  EXPECT_DOUBLE_EQ(target.existenceProbability, 0.875);
  EXPECT_EQ(target.seeingCameras, std::vector<int>{0});
}

TEST(FrameMessage, OfATargetThatIsNotHeldOnlyItsStateIsKnown) {
  RecentPositions recent;
  const TrackSnapshot snapshot = snapshotAt(0, 0.0, {0.1, 0.2, 0.3}, false);
  recent.add(snapshot);
  const broadcast::TargetMessage target = messageOf(snapshot, recent).targets.at(0);
  EXPECT_EQ(target.state, "searching");
  EXPECT_FALSE(target.position);
  EXPECT_FALSE(target.velocity);
  EXPECT_TRUE(target.seeingCameras.empty());
  EXPECT_DOUBLE_EQ(target.existenceProbability, 0.25);
}

TEST(FrameMessage, AxesAndUnitAreThoseThatAreChosen) {
  RecentPositions recent;
  const TrackSnapshot snapshot = snapshotAt(0, 0.0, {0.1, 0.2, 0.3});
  recent.add(snapshot);
  const auto y = messageOf(snapshot, recent, {OutputAxes::YUp, OutputUnit::Millimeter});
  EXPECT_TRUE(y.targets[0].position->isApprox(Eigen::Vector3d(200.0, 300.0, 100.0)));
  EXPECT_NEAR(y.targets[0].covariance(0, 0), 4.0, 1e-9); // mm², of y
  const auto left = messageOf(snapshot, recent, {OutputAxes::YUpLeftHanded, OutputUnit::Meter});
  EXPECT_TRUE(left.targets[0].position->isApprox(Eigen::Vector3d(0.1, 0.3, 0.2)));
  for (const OutputAxes axes : {OutputAxes::ZUp, OutputAxes::YUp, OutputAxes::YUpLeftHanded}) {
    const double handedness = OutputCoordinates{axes, {}}.outputFromWorld().determinant();
    EXPECT_DOUBLE_EQ(handedness, axes == OutputAxes::YUpLeftHanded ? -1.0 : 1.0);
  }
}

TEST(FrameMessage, TheRigHasCamerasAndVolumeInTheSameCoordinates) {
  const TrackSnapshot snapshot = snapshotAt(0, 0.0, {0.0, 0.0, 0.0});
  const auto rig = rigMessageOf(snapshot, {OutputAxes::YUp, OutputUnit::Millimeter},
                                WorldBox{{0.0, 1.0, 2.0}, {3.0, 4.0, 5.0}});
  ASSERT_EQ(rig.cameras.size(), 2U);
  EXPECT_EQ(rig.cameras[0].name, "left");
  EXPECT_TRUE(rig.cameras[0].position.isApprox(Eigen::Vector3d(-1000.0, 1000.0, 3000.0)));
  EXPECT_NEAR(rig.cameras[0].direction.norm(), 1.0, 1e-12);
  EXPECT_LT(rig.cameras[0].direction.z(), 0.0);
  EXPECT_TRUE(rig.volume.min.isApprox(Eigen::Vector3d(1000.0, 2000.0, 0.0)));
  EXPECT_TRUE(rig.volume.max.isApprox(Eigen::Vector3d(4000.0, 5000.0, 3000.0)));
  // Without a volume of interest, it is what both cameras see.
  const auto seen = rigMessageOf(snapshot, {}, std::nullopt).volume;
  EXPECT_TRUE(seen.contains({0.0, 0.0, 0.0}));
}

TEST(FrameMessage, VelocitiesDoNotSpanGapsAndRestarts) {
  RecentPositions recent;
  recent.add(snapshotAt(0, 0.0, {0.0, 0.0, 0.0}));
  EXPECT_FALSE(recent.velocity("ball"));
  recent.add(snapshotAt(1, 0.1, {0.1, 0.0, 0.0}));
  EXPECT_TRUE(recent.velocity("ball"));
  recent.add(snapshotAt(2, 0.2, {0.2, 0.0, 0.0}, false));
  EXPECT_FALSE(recent.velocity("ball"));
  recent.add(snapshotAt(3, 0.3, {0.3, 0.0, 0.0}));
  EXPECT_FALSE(recent.velocity("ball"));
  recent.add(snapshotAt(5, 0.5, {0.5, 0.0, 0.0})); // one frame was dropped, which is no gap
  ASSERT_TRUE(recent.velocity("ball"));
  EXPECT_NEAR(recent.velocity("ball")->x(), 1.0, 1e-9);
  recent.add(snapshotAt(0, 0.0, {5.0, 0.0, 0.0}));
  EXPECT_FALSE(recent.velocity("ball"));
  EXPECT_FALSE(recent.velocity("nobody"));
}

TEST(FrameMessage, AnAccelerationIsTheChangeOfTheVelocity) {
  RecentPositions recent;
  for (int k = 0; k < 10; ++k) {
    const double time = 0.1 * k;
    recent.add(snapshotAt(k, time, {time * time, 0.0, 0.0}));
  }
  EXPECT_NEAR(recent.acceleration("ball").x(), 2.0, 1e-9);
  // The middle of the last four positions was one and a half frames ago.
  EXPECT_NEAR(recent.velocity("ball")->x(), 2.0 * (0.9 - 0.15), 1e-9);
}

TEST(FrameMessage, EachStateHasAWord) {
  EXPECT_STREQ(broadcast::stateWord(TrackingState::Held), "held");
  EXPECT_STREQ(broadcast::stateWord(TrackingState::Ambiguous), "ambiguous");
  EXPECT_STREQ(broadcast::stateWord(TrackingState::Lost), "lost");
  EXPECT_STREQ(broadcast::stateWord(TrackingState::Gone), "gone");
  EXPECT_STREQ(broadcast::stateWord(TrackingState::Learning), "searching");
}

} // namespace
} // namespace dewpoint::tests
