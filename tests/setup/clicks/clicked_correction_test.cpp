// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/clicks/clicked_correction.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// Both look along +z (x right, y down), the second one 1 m to the right: the pixel of (x, y, z) is
/// 320 + 500 (x - at) / z, 240 + 500 y / z.
CameraRig pair() {
  CameraRig rig(2);
  for (Camera& camera : rig) {
    camera.intrinsics = {640, 480, 500.0, 500.0, 320.0, 240.0};
  }
  rig[1].cameraFromWorld.translation() = Eigen::Vector3d(-1.0, 0.0, 0.0);
  return rig;
}

PointClick clickSeenBy(int camera, const Eigen::Vector3d& point) {
  return {
      camera,
      {320.0 + 500.0 * (point.x() - camera) / point.z(), 240.0 + 500.0 * point.y() / point.z()}};
}

const Eigen::Vector3d kThere(0.4, 0.1, 2.0);
const std::optional<Gaussian3> kEstimate =
    Gaussian3{{0.1, 0.0, 2.5}, 1e-4 * Eigen::Matrix3d::Identity()};

TEST(ClickedCorrection, OfOneImageKeepsTheDepthOfTheEstimate) {
  const auto made = correctionFromClick({}, pair(), 7, 2, clickSeenBy(0, kThere), kEstimate);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->frame, 7);
  EXPECT_EQ(made->target, 2);
  EXPECT_EQ(made->clicks, std::vector<PointClick>{clickSeenBy(0, kThere)});
  // On the ray of the click, as far along it as the estimate is.
  const Eigen::Vector3d along = kThere.normalized();
  EXPECT_LT((made->position - along * along.dot(kEstimate->mean)).norm(), 1e-9);
}

TEST(ClickedCorrection, OfASecondImageIsWhereTheRaysMeet) {
  Project project;
  const auto first = correctionFromClick(project, pair(), 7, 0, clickSeenBy(0, kThere), kEstimate);
  ASSERT_TRUE(first);
  EXPECT_GT((first->position - kThere).norm(), 0.1); // its depth was not known
  addCorrection(project, *first);
  const auto second = correctionFromClick(project, pair(), 7, 0, clickSeenBy(1, kThere), kEstimate);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->clicks.size(), 2U);
  EXPECT_LT((second->position - kThere).norm(), 1e-9);
  EXPECT_LT(second->covariance.trace(), first->covariance.trace());
}

TEST(ClickedCorrection, ReplacesTheClickOfItsCamera) {
  Project project;
  const Eigen::Vector3d wrong(0.2, -0.2, 1.6);
  for (const PointClick& click :
       {clickSeenBy(0, wrong), clickSeenBy(1, kThere), clickSeenBy(0, kThere)}) {
    const auto made = correctionFromClick(project, pair(), 7, 0, click, std::nullopt);
    ASSERT_TRUE(made) << made.error().detail;
    addCorrection(project, *made);
  }
  ASSERT_EQ(project.corrections.size(), 1U);
  EXPECT_EQ(project.corrections[0].clicks,
            (std::vector<PointClick>{clickSeenBy(0, kThere), clickSeenBy(1, kThere)}));
  EXPECT_LT((project.corrections[0].position - kThere).norm(), 1e-9);
}

TEST(ClickedCorrection, KnowsNothingOfOtherFramesAndTargets) {
  Project project;
  addCorrection(project,
                *correctionFromClick(project, pair(), 7, 0, clickSeenBy(0, kThere), kEstimate));
  EXPECT_NE(correctionAt(project, 7, 0), nullptr);
  EXPECT_EQ(correctionAt(project, 8, 0), nullptr);
  EXPECT_EQ(correctionAt(project, 7, 1), nullptr);
  for (const auto& [frame, target] : {std::pair(8, 0), std::pair(7, 1)}) {
    const auto made =
        correctionFromClick(project, pair(), frame, target, clickSeenBy(1, kThere), kEstimate);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->clicks.size(), 1U);
  }
}

TEST(ClickedCorrection, SaysWhatCannotBe) {
  EXPECT_FALSE(correctionFromClick({}, pair(), 0, 0, {2, {1.0, 1.0}}, kEstimate));
  Project project; // rays that part in front of the cameras
  addCorrection(project, *correctionFromClick({}, pair(), 0, 0, {0, {20.0, 240.0}}, kEstimate));
  EXPECT_FALSE(correctionFromClick(project, pair(), 0, 0, {1, {620.0, 240.0}}, kEstimate));
}

} // namespace
} // namespace dewpoint::tests
