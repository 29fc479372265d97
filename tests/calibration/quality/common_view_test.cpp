// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/quality/common_view.h"
#include "tests/calibration/waved_rig.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dewpoint::tests {
namespace {

using namespace simulated;

TEST(CommonView, ContainsWhatTwoCamerasSee) {
  const CameraRig cameras = rig(2);
  std::vector<Eigen::Vector3d> targets;
  for (int i = 0; i < 200; ++i) {
    targets.push_back(waved(2, 0.1 * i, 0));
  }
  const CommonView view = findCommonView(cameras, targets);
  ASSERT_GT(view.positions.size(), 100U);
  ASSERT_EQ(view.camerasPerPosition.size(), view.positions.size());
  for (std::size_t i = 0; i < view.positions.size(); ++i) {
    EXPECT_GE(view.camerasPerPosition[i].size(), 2U);
    for (const std::size_t camera : view.camerasPerPosition[i]) {
      const auto pixel = Projector(cameras[camera]).project(view.positions[i]);
      ASSERT_TRUE(pixel);
      EXPECT_TRUE(inImage(cameras[camera], *pixel));
      EXPECT_LT((view.positions[i] - cameras[camera].center()).norm(), 6.0);
    }
  }
}

TEST(CommonView, OneCameraHasNone) {
  EXPECT_TRUE(findCommonView({rig(2)[0]}, {{0.0, 0.0, 1.0}}).positions.empty());
  EXPECT_TRUE(findCommonView(rig(2), {}).positions.empty());
}

TEST(PrincipalBox, LiesAlongThePositions) {
  std::vector<Eigen::Vector3d> positions;
  const Eigen::Matrix3d turned = rotationExponential(Eigen::Vector3d(0.3, -0.2, 0.5));
  for (int x = -4; x <= 4; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (int z = -1; z <= 1; ++z) {
        positions.emplace_back(Eigen::Vector3d(1.0, 2.0, 3.0) +
                               turned * Eigen::Vector3d(0.1 * x, 0.1 * y, 0.1 * z));
      }
    }
  }
  const PrincipalBox box = principalBox(positions, 0.0);
  EXPECT_TRUE(box.extents().isApprox(Eigen::Vector3d(0.8, 0.4, 0.2), 1e-9));
  EXPECT_NEAR(std::abs(box.axes.col(0).dot(turned.col(0))), 1.0, 1e-9);
  EXPECT_NEAR(box.distanceTo(box.center), 0.0, 1e-12);
  EXPECT_NEAR(box.distanceTo(box.center + turned * Eigen::Vector3d(0.7, 0.0, 0.5)), 0.5, 1e-9);
  EXPECT_EQ(principalBox({}, 0.1).extents(), Eigen::Vector3d::Zero());
}

} // namespace
} // namespace dewpoint::tests
