// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/snapshot/sight_lines.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace dewpoint::tests {
namespace {

/// Two cameras and a held target that both of them see.
TrackSnapshot heldBall() {
  TrackSnapshot snapshot;
  snapshot.rig = std::make_shared<const CameraRig>(test::twoCameras());
  SphereEstimate sphere;
  sphere.mean = test::kBall;
  sphere.particleCount = 100;
  sphere.isValid = true;
  snapshot.targets.emplace_back().estimate = sphere;
  return snapshot;
}

TEST(SightLines, EachCameraSeesAHeldTarget) {
  const TrackSnapshot snapshot = heldBall();
  const auto lines = sightLines(snapshot, snapshot.targets[0]);
  ASSERT_EQ(lines.size(), 2U);
  for (const SightLine& line : lines) {
    EXPECT_TRUE(line.seesTarget);
    EXPECT_EQ(line.from, (*snapshot.rig)[static_cast<std::size_t>(line.camera)].center());
    EXPECT_EQ(line.to, test::kBall);
  }
}

TEST(SightLines, ReasonsSayWhereItIsHidden) {
  TrackSnapshot snapshot = heldBall();
  snapshot.targets[0].cameraReports = {{CameraStatus::Hidden}, {CameraStatus::PartlyHidden}};
  auto lines = sightLines(snapshot, snapshot.targets[0]);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_FALSE(lines[0].seesTarget);
  EXPECT_TRUE(lines[1].seesTarget);
  snapshot.targets[0].cameraReports = {{CameraStatus::NoImage}, {CameraStatus::OutOfView}};
  EXPECT_TRUE(sightLines(snapshot, snapshot.targets[0]).empty());
}

TEST(SightLines, EvidenceStandsForReasonsThatAreNotGiven) {
  TrackSnapshot snapshot = heldBall();
  auto& sphere = std::get<SphereEstimate>(snapshot.targets[0].estimate);
  sphere.cameras = {{.isInView = true, .visibleShare = 0.0}, {.isInView = false}};
  const auto lines = sightLines(snapshot, snapshot.targets[0]);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].camera, 0);
  EXPECT_FALSE(lines[0].seesTarget);
}

TEST(SightLines, NothingBesideTheImagesOrWithoutAPosition) {
  TrackSnapshot snapshot = heldBall();
  auto& sphere = std::get<SphereEstimate>(snapshot.targets[0].estimate);
  sphere.mean = (*snapshot.rig)[0].center() - 5.0 * (*snapshot.rig)[0].opticalAxis();
  for (const SightLine& line : sightLines(snapshot, snapshot.targets[0])) {
    EXPECT_NE(line.camera, 0); // it is behind this one
  }
  sphere.mean.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(sightLines(snapshot, snapshot.targets[0]).empty());
  snapshot.targets[0].estimate = BoxEstimate{};
  EXPECT_TRUE(sightLines(snapshot, snapshot.targets[0]).empty());
}

const PointClick kCenterOfLeft{0, {79.5, 59.5}}; // where both cameras look

TEST(SightLines, TheRayOfAClickGoesThroughTheOtherImage) {
  const TrackSnapshot snapshot = heldBall();
  const auto lines = clickedRayLines(snapshot, kCenterOfLeft, 1);
  ASSERT_EQ(lines.size(), 1U);
  double low = 1e9;
  double high = -1e9;
  for (const Eigen::Vector2d& pixel : lines[0]) {
    EXPECT_NEAR(pixel.y(), 59.5, 1e-6); // the cameras are equally high
    low = std::min(low, pixel.x());
    high = std::max(high, pixel.x());
  }
  EXPECT_LT(low, 79.5);
  EXPECT_GT(high, 79.5);
}

TEST(SightLines, NoRayInTheImageOfTheClickOrWithoutACamera) {
  EXPECT_TRUE(clickedRayLines(heldBall(), kCenterOfLeft, 0).empty());
  EXPECT_TRUE(clickedRayLines(heldBall(), kCenterOfLeft, 2).empty());
  EXPECT_TRUE(clickedRayLines(heldBall(), {2, {79.5, 59.5}}, 1).empty());
  EXPECT_TRUE(clickedRayLines({}, kCenterOfLeft, 1).empty());
  EXPECT_TRUE(clickedRayEnds(heldBall(), {-1, {79.5, 59.5}}, test::kBall).empty());
}

TEST(SightLines, TheRayOfAClickEndsAQuarterBeyondThePosition) {
  const TrackSnapshot snapshot = heldBall();
  const auto line = clickedRayEnds(snapshot, kCenterOfLeft, test::kBall);
  ASSERT_EQ(line.size(), 2U);
  EXPECT_EQ(line[0], (*snapshot.rig)[0].center());
  // 0.6 m away along y: it goes on for 0.15 m.
  EXPECT_LT((line[1] - test::kBall - Eigen::Vector3d(0.0, 0.15, 0.0)).norm(), 1e-9);
}

TEST(SightLines, DashesBeginAndEndWithAStroke) {
  const auto strokes = dashedLine(Eigen::Vector3d::Zero(), {9.0, 0.0, 0.0}, 5);
  ASSERT_EQ(strokes.size(), 5U);
  EXPECT_DOUBLE_EQ(strokes[1][0].x(), 2.0);
  EXPECT_DOUBLE_EQ(strokes[1][1].x(), 3.0);
  EXPECT_DOUBLE_EQ(strokes[4][1].x(), 9.0);
}

} // namespace
} // namespace dewpoint::tests
