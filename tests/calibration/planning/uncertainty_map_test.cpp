// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/calibration/planning/uncertainty_map.h"
#include "core/geometry/projector.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

Camera cameraToward(const Eigen::Vector3d& position, const Eigen::Vector3d& target) {
  Camera camera;
  camera.intrinsics = {640, 480, 500.0, 500.0, 319.5, 239.5};
  camera.cameraFromWorld = lookAt(position, target);
  return camera;
}

const VolumeGrid kOneCell{{-0.05, -0.05, 0.95}, {0.05, 0.05, 1.05}, {1, 1, 1}};

TEST(UncertaintyMap, TwoCamerasAtRightAnglesAreWorkedByHand) {
  // Along +x and along +y at 2 m and 500 px: one pixel is 4 mm across. x is seen by one camera only
  // and y by the other: 4 mm each; z by both: 4 / sqrt(2).
  UncertaintyMap map(kOneCell, 1.0);
  map.setRig({cameraToward({-2, 0, 1}, {0, 0, 1}), cameraToward({0, -2, 1}, {0, 0, 1})});
  EXPECT_EQ(map.cameraCounts()[0], 2);
  EXPECT_NEAR(map.axisSigmas()[0][0], 0.004, 1e-6);
  EXPECT_NEAR(map.axisSigmas()[0][1], 0.004, 1e-6);
  EXPECT_NEAR(map.axisSigmas()[0][2], 0.004 / std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(map.largestSigmas()[0], 0.004, 1e-6);
}

TEST(UncertaintyMap, ErrorsOfThePoseAddUp) {
  // A direction known to 1 mrad is 2 mm at 2 m; a place known to 3 mm is 3 mm; a pixel 4 mm. Roll
  // does nothing on the axis.
  const auto pose = poseCovariance(1e-3, 3e-3);
  UncertaintyMap map(kOneCell, 1.0);
  map.setRig({cameraToward({-2, 0, 1}, {0, 0, 1}), cameraToward({0, -2, 1}, {0, 0, 1})},
             std::array{pose, pose});
  EXPECT_NEAR(map.axisSigmas()[0][0], std::sqrt(16.0 + 4.0 + 9.0) * 1e-3, 1e-6);
}

TEST(UncertaintyMap, UnseenCellsHaveNoValue) {
  const VolumeGrid grid{{-1, -1, 0}, {1, 1, 2}, {2, 2, 2}};
  UncertaintyMap map(grid, 1.0);
  EXPECT_TRUE(std::isnan(map.largestSigmas()[0]));
  map.setRig({cameraToward({-3, 0, 1}, {0, 0, 1})});
  EXPECT_EQ(map.cameraCounts()[0], 1);
  EXPECT_TRUE(std::isnan(map.largestSigmas()[0])); // one camera knows no depth
  // Two cameras that look at each other past the only cell between them: nothing along their line.
  UncertaintyMap line(kOneCell, 1.0);
  line.setRig({cameraToward({-3, 0, 1}, {0, 0, 1}), cameraToward({3, 0, 1}, {0, 0, 1})});
  EXPECT_EQ(line.cameraCounts()[0], 2);
  EXPECT_TRUE(std::isnan(line.largestSigmas()[0]));
  // Behind a camera.
  UncertaintyMap behind(kOneCell, 1.0);
  behind.setRig({cameraToward({-3, 0, 1}, {-9, 0, 1}), cameraToward({3, 0, 1}, {0, 0, 1})});
  EXPECT_EQ(behind.cameraCounts()[0], 1);
  EXPECT_EQ(behind.fractionWithin(1.0), 0.0);
}

TEST(UncertaintyMap, AMovedCameraGivesWhatTheWholeRigGives) {
  const VolumeGrid grid{{-1, -1, 0}, {1, 1, 2}, {5, 4, 3}};
  CameraRig rig = {cameraToward({-3, 0, 2}, {0, 0, 1}), cameraToward({0, -3, 2}, {0, 0, 1}),
                   cameraToward({3, 1, 2}, {0, 0, 1})};
  UncertaintyMap moved(grid, 0.5);
  moved.setRig(rig);
  rig[1] = cameraToward({1, -3, 1.5}, {0.2, 0, 1});
  moved.setCamera(1, rig[1]);
  UncertaintyMap whole(grid, 0.5);
  whole.setRig(rig);
  for (std::size_t i = 0; i < grid.cellCount(); ++i) {
    ASSERT_GE(whole.cameraCounts()[i], 2); // so that there is a value to compare
    EXPECT_EQ(moved.largestSigmas()[i], whole.largestSigmas()[i]);
  }
  EXPECT_EQ(whole.layer(2).size(), 20U);
  EXPECT_EQ(whole.layer(2)[7], whole.largestSigmas()[grid.index(2, 1, 2)]);
  EXPECT_EQ(whole.layerAt(0.1), 0);
  EXPECT_EQ(whole.layerAt(2.0), 2);
  EXPECT_EQ(whole.layerAt(2.1), std::nullopt);
  EXPECT_EQ(grid.center(0, 0, 0), Eigen::Vector3d(-0.8, -0.75, 1.0 / 3.0));
}

/// The point of least squared pixel distance, by Gauss and Newton from the truth.
Eigen::Vector3d triangulated(const std::vector<Projector>& cameras,
                             const std::vector<Eigen::Vector2d>& pixels, Eigen::Vector3d point) {
  for (int step = 0; step < 5; ++step) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < cameras.size(); ++k) {
      const Projector& projector = cameras[k];
      const Eigen::Vector2d at = *projector.project(point);
      Eigen::Matrix<double, 2, 3> by;
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d there = point + 1e-5 * Eigen::Vector3d::Unit(axis);
        by.col(axis) = (*projector.project(there) - at) / 1e-5;
      }
      normal += by.transpose() * by;
      right += by.transpose() * (pixels[k] - at);
    }
    point += normal.ldlt().solve(right);
  }
  return point;
}

TEST(UncertaintyMap, PredictsWhatNoisyTriangulationDoes) {
  CameraRig rig = {cameraToward({-3, 0.5, 2}, {0, 0, 1}), cameraToward({0.5, -2.5, 1.2}, {0, 0, 1}),
                   cameraToward({2, 2, 2}, {0, 0, 1})};
  for (Camera& camera : rig) {
    camera.distortion = {-0.2, 0.05, 0.001, -0.002};
  }
  rig[2].lens = LensModel::Fisheye;
  rig[2].distortion = {0.02, -0.01, 0.002, 0.0};
  const VolumeGrid grid{{0.25, 0.35, 1.25}, {0.35, 0.45, 1.35}, {1, 1, 1}};
  UncertaintyMap map(grid, 0.7);
  map.setRig(rig);
  const Eigen::Vector3d truth = grid.center(0, 0, 0);
  std::vector<Projector> projectors;
  for (const Camera& camera : rig) {
    projectors.emplace_back(camera);
  }
  const RandomStream random(7, 0, 0, RandomPurpose::Noise);
  Eigen::Array3d squares = Eigen::Array3d::Zero();
  constexpr int kTrials = 4000;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<Eigen::Vector2d> pixels;
    for (std::size_t k = 0; k < rig.size(); ++k) {
      const auto noise = random.normal4(std::uint32_t(trial), std::uint32_t(k));
      pixels.push_back(*projectors[k].project(truth) + 0.7 * Eigen::Vector2d(noise[0], noise[1]));
    }
    squares += (triangulated(projectors, pixels, truth) - truth).array().square();
  }
  for (int axis = 0; axis < 3; ++axis) {
    // A standard deviation from 4000 trials is itself known to 1.1 %.
    EXPECT_NEAR(std::sqrt(squares[axis] / kTrials) / double(map.axisSigmas()[0][std::size_t(axis)]),
                1.0, 0.05);
  }
}

} // namespace
} // namespace dewpoint::tests
