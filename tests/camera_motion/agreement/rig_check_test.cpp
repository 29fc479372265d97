// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_motion/agreement/rig_check.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// Two cameras of a desk, their positions in a unit of which `unit` make a meter.
CameraRig desk(double unit) {
  CameraRig rig(2);
  rig[0].cameraFromWorld = lookAt(unit * Eigen::Vector3d(1.0, 0.2, 0.6), {0.0, 0.0, 0.0});
  rig[1].cameraFromWorld = lookAt(unit * Eigen::Vector3d(-1.1, 0.3, 0.7), {0.0, 0.0, 0.0});
  return rig;
}

TEST(RigCheck, NothingIsWrongWithADeskInMeters) {
  EXPECT_TRUE(checkRig(desk(1.0)).empty());
}

TEST(RigCheck, CamerasKilometersApartAreInMillimeters) {
  const auto found = checkRig(desk(1000.0));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].fault, CameraFault::Unit);
  EXPECT_DOUBLE_EQ(found[0].metersPerUnit, 0.001);
}

// 2.1 m in centimeters; in millimeters the cameras would be 21 cm apart.
TEST(RigCheck, CamerasTwoHundredMetersApartAreInCentimeters) {
  const auto found = checkRig(desk(100.0));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_DOUBLE_EQ(found[0].metersPerUnit, 0.01);
}

TEST(RigCheck, TwoCamerasOfOnePoseAreNamed) {
  CameraRig rig = desk(1.0);
  rig.push_back(rig[0]);
  const auto found = checkRig(rig);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].fault, CameraFault::SamePose);
  EXPECT_EQ(found[0].cameras, (std::vector<std::size_t>{0, 2}));
  rig[2].cameraFromWorld.translation() += Eigen::Vector3d(0.0, 0.06, 0.0); // a pair of eyes
  EXPECT_TRUE(checkRig(rig).empty());
}

TEST(RigCheck, ARatioOfLengthsIsThatOfAUnit) {
  EXPECT_DOUBLE_EQ(lengthUnitFromRatio(1100.0), 0.001);
  EXPECT_DOUBLE_EQ(lengthUnitFromRatio(93.0), 0.01);
  EXPECT_DOUBLE_EQ(lengthUnitFromRatio(41.0), 0.0254);
  EXPECT_DOUBLE_EQ(lengthUnitFromRatio(1.0), 0.0);
  EXPECT_DOUBLE_EQ(lengthUnitFromRatio(10.0), 0.0); // rather a radius
}

} // namespace
} // namespace dewpoint::tests
