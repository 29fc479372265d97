// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/quality/missing_motion.h"
#include "tests/calibration/waved_rig.h"

#include <gtest/gtest.h>

#include <functional>

namespace dewpoint::tests {
namespace {

using namespace simulated;

/// Where the ball is, at each time in seconds.
using BallPath = std::function<Eigen::Vector3d(double)>;

/// Four cameras around a hall.
CameraRig hall() {
  return rig(3);
}

/// A ball, as all cameras see it that have it in their images and do not look away.
WandResult followed(const CameraRig& rig, const BallPath& path, double seconds = 30.0,
                    const std::function<bool(std::size_t, double)>& looks = nullptr) {
  WandResult result;
  result.cameras = rig;
  result.bundle.cameras = rig;
  result.problem.bodies = {{.name = "ball"}};
  for (int f = 0; f < static_cast<int>(seconds * kRate); ++f) {
    const double time = f / kRate;
    BundleState state{.time = time, .isPositionKnown = true};
    state.ends[0] = path(time);
    for (std::size_t c = 0; c < rig.size(); ++c) {
      const auto pixel = Projector(rig[c]).project(state.ends[0]);
      if (pixel && inImage(rig[c], *pixel) && (!looks || looks(c, time))) {
        result.problem.observations.push_back(
            {.camera = c, .state = result.bundle.states.size(), .pixel = *pixel});
        result.bundle.residuals.emplace_back(0.1, 0.0);
      }
    }
    result.bundle.states.push_back(state);
  }
  return result;
}

Eigen::Vector3d everywhere(double time) {
  return waved(3, time, 0);
}

std::string texts(const std::vector<MotionGap>& gaps) {
  std::string all;
  for (const MotionGap& gap : gaps) {
    all += motionGapText(gap, hall()) + "\n";
  }
  return all;
}

TEST(MissingMotion, AWaveThroughTheVolumeLacksNothing) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    const CameraRig cameras = rig(seed, 2 + static_cast<int>(seed % 4));
    const auto gaps =
        findMissingMotion(followed(cameras, [&](double time) { return waved(seed, time, 0); }));
    EXPECT_TRUE(gaps.empty()) << seed << " " << texts(gaps);
  }
}

TEST(MissingMotion, AShortRecordingIsNamed) {
  const auto gaps = findMissingMotion(followed(hall(), everywhere, 6.0));
  ASSERT_FALSE(gaps.empty());
  EXPECT_EQ(gaps[0].missingMotion, MissingMotion::Duration);
  EXPECT_EQ(motionGapText(gaps[0], hall()),
            "The ball was seen for only 6 s. Wave for half a minute.");
}

TEST(MissingMotion, ALineIsNamed) {
  const auto gaps = findMissingMotion(followed(hall(), [](double time) {
    return Eigen::Vector3d(0.9 * std::sin(time), 0.02 * std::sin(3.0 * time), 1.0);
  }));
  ASSERT_FALSE(gaps.empty());
  EXPECT_EQ(gaps[0].missingMotion, MissingMotion::OffTheLine) << texts(gaps);
  EXPECT_NEAR(gaps[0].motionAmount, 0.04, 0.01);
}

// Whoever throws a ball from hand to hand moves it in a plane.
TEST(MissingMotion, APlaneIsNamedWithTheCameraThatLooksAcrossIt) {
  CameraRig cameras = hall();
  cameras[2].cameraFromWorld = lookAt({0.0, -3.0, 1.2}, {0.0, 0.0, 1.0});
  const auto gaps = findMissingMotion(followed(cameras, [](double time) {
    return Eigen::Vector3d(0.9 * std::sin(1.1 * time), 0.03 * std::sin(time),
                           1.0 + 0.5 * std::sin(1.7 * time));
  }));
  ASSERT_FALSE(gaps.empty());
  EXPECT_EQ(gaps[0].missingMotion, MissingMotion::OffThePlane) << texts(gaps);
  EXPECT_EQ(gaps[0].cameras, std::vector<std::size_t>{2});
  EXPECT_EQ(motionGapText(gaps[0], cameras),
            "The ball moved only within a plane (6 cm thick). Also move it across this plane: "
            "toward camera 3 and away from it.");
}

TEST(MissingMotion, ASmallPartOfTheVolumeIsNamed) {
  const auto gaps = findMissingMotion(followed(hall(), [](double time) {
    const Eigen::Vector3d wide = everywhere(time) - Eigen::Vector3d(0.0, 0.0, 1.0);
    return Eigen::Vector3d(0.3 * wide + Eigen::Vector3d(0.0, 0.0, 1.0));
  }));
  ASSERT_FALSE(gaps.empty());
  EXPECT_EQ(gaps[0].missingMotion, MissingMotion::WholeVolume) << texts(gaps);
  EXPECT_LT(gaps[0].motionAmount, 0.02);
}

/// Two cameras side by side, which look along y.
CameraRig sideBySideRig() {
  CameraRig cameras = rig(3, 2);
  cameras[0].cameraFromWorld = lookAt({-0.2, -2.5, 1.0}, {0.0, 0.0, 1.0});
  cameras[1].cameraFromWorld = lookAt({0.2, -2.5, 1.0}, {0.0, 0.0, 1.0});
  return cameras;
}

TEST(MissingMotion, NoDepthIsNamed) {
  const auto gaps = findMissingMotion(followed(sideBySideRig(), [](double time) {
    return Eigen::Vector3d(0.9 * std::sin(1.1 * time), 0.1 * std::sin(0.7 * time),
                           1.0 + 0.7 * std::sin(1.7 * time));
  }));
  ASSERT_FALSE(gaps.empty());
  EXPECT_EQ(gaps[0].missingMotion, MissingMotion::InDepth) << texts(gaps);
  EXPECT_NEAR(gaps[0].motionAmount, 0.25, 0.08); // 0.2, and what the cameras are turned inward
}

TEST(MissingMotion, TheMissingSideOfAnImageIsNamed) {
  const auto gaps =
      findMissingMotion(followed(sideBySideRig(), [](double time) { // never on the left
        return Eigen::Vector3d(1.05 + 0.25 * std::sin(1.1 * time), 0.6 * std::sin(0.7 * time),
                               1.0 + 0.5 * std::sin(1.7 * time));
      }));
  ASSERT_FALSE(gaps.empty());
  EXPECT_EQ(gaps[0].missingMotion, MissingMotion::WholeImage) << texts(gaps);
  EXPECT_EQ(gaps[0].side, ImageSide::Left);
  EXPECT_NE(texts(gaps).find("Also move it to the left part of its image."), std::string::npos);
}

TEST(MissingMotion, CamerasThatNeverSawItTogetherAreNamed) {
  const auto gaps =
      findMissingMotion(followed(hall(), everywhere, 30.0, [](std::size_t camera, double time) {
        return camera == 1 ? time < 15.0 : camera != 2 || time >= 14.7; // 5 frames in common
      }));
  ASSERT_EQ(gaps.size(), 1U) << texts(gaps);
  EXPECT_EQ(gaps[0].missingMotion, MissingMotion::SeenTogether);
  EXPECT_EQ(gaps[0].cameras, (std::vector<std::size_t>{1, 2}));
  EXPECT_LE(gaps[0].motionAmount, 5.0);
}

TEST(MissingMotion, WithoutPositionsNothingIsSaid) {
  EXPECT_TRUE(findMissingMotion({}).empty());
  EXPECT_TRUE(findMissingMotion(followed(hall(), everywhere, 0.1)).empty());
}

} // namespace
} // namespace dewpoint::tests
