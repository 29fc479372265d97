// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/seen_volume.h"
#include "tests/geometry/scaled_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

/// 201 x 201 pixels, focal length 200 px: the image's borders lie at a slope of 1/2.
Camera cameraAt(const Eigen::Vector3d& position, const Eigen::Vector3d& target) {
  Camera camera;
  camera.intrinsics = {201, 201, 200.0, 200.0, 100.0, 100.0};
  camera.cameraFromWorld = lookAt(position, target);
  return camera;
}

/// At 1 m from the origin on x and on y, both looking at it: their axes meet there.
CameraRig twoCameras() {
  return {cameraAt({1, 0, 0}, {0, 0, 0}), cameraAt({0, 1, 0}, {0, 0, 0})};
}

/// Four cameras below the ceiling in the corners of a room of 10 x 10 m.
CameraRig roomRig() {
  CameraRig rig;
  for (const double x : {0.0, 10.0}) {
    for (const double y : {0.0, 10.0}) {
      rig.push_back(cameraAt({x, y, 2.5}, {5.0, 5.0, 1.0}));
    }
  }
  return rig;
}

// The first sees |y|, |z| <= (1 - x) / 2, the second |x|, |z| <= (1 - y) / 2, each up to 1.5 m
// away. Largest x: where y = -(1 - x) / 2 and x = (1 - y) / 2 meet, 0.6. Smallest x: 1.5 m from the
// first on its axis, -0.5. Largest z: on the upper borders of both, x = y = -t, z = (1 + t) /
// 2, 1.5 m away: 1.25 (1 + t)^2 + t^2 = 2.25, t = 0.312, z = 0.656. Points lie 47 mm apart on a
// ray.
TEST(SeenVolume, IsTheBoxOfWhatTwoCamerasSee) {
  const auto box = seenVolume(twoCameras());
  ASSERT_TRUE(box.has_value());
  for (const Eigen::Index axis : {0, 1}) {
    EXPECT_NEAR(box->min[axis], -0.5, 0.06);
    EXPECT_NEAR(box->max[axis], 0.6, 0.06);
  }
  EXPECT_NEAR(box->min.z(), -0.656, 0.06);
  EXPECT_NEAR(box->max.z(), 0.656, 0.06);
}

TEST(SeenVolume, GrowsWithTheRig) {
  const auto desk = seenVolume(scaled(twoCameras(), 0.5));
  const auto hall = seenVolume(scaled(twoCameras(), 16.0)); // 32 times as large, without rounding
  ASSERT_TRUE(desk && hall);
  EXPECT_LT((hall->min - 32.0 * desk->min).norm(), 1e-9);
  EXPECT_LT((hall->max - 32.0 * desk->max).norm(), 1e-9);
  EXPECT_EQ(seenVolume(scaled(twoCameras(), 0.5)), desk);
}

// The middle of the room is 7.2 m from each camera: nothing beyond 10.9 m counts.
TEST(SeenVolume, HoldsTheMiddleOfARoom) {
  const auto box = seenVolume(roomRig());
  ASSERT_TRUE(box.has_value());
  EXPECT_TRUE(box->contains({5.0, 5.0, 1.0}));
  EXPECT_TRUE(box->contains({3.0, 3.0, 0.2}));
  EXPECT_TRUE(box->contains({7.0, 7.0, 1.8}));
  EXPECT_NEAR(box->center().x(), 5.0, 0.5);
  EXPECT_NEAR(box->center().y(), 5.0, 0.5);
  EXPECT_LT(box->halfSize().maxCoeff(), 10.9);
}

// A camera beside the first, 0.2 degrees off: their axes meet 14 m away.
TEST(SeenVolume, IsNotStretchedByAxesThatAreNearlyParallel) {
  CameraRig rig = twoCameras();
  rig.push_back(cameraAt({0, -1, 0}, {0, 0, 0}));
  rig.push_back(cameraAt({1.0, 0.05, 0.0}, {-13.0, 0.0, 0.0}));
  const auto box = seenVolume(rig);
  ASSERT_TRUE(box.has_value());
  EXPECT_LT((box->center()).norm(), 0.6);
  EXPECT_LT(box->halfSize().maxCoeff(), 1.5);
}

TEST(SeenVolume, LeavesOutACameraThatLooksAway) {
  CameraRig rig = twoCameras();
  const auto expected = seenVolume(rig);
  rig.push_back(cameraAt({2.0, 2.0, 0.0}, {5.0, 5.0, 0.0}));
  EXPECT_EQ(seenVolume(rig), expected);
}

// As far as nothing else says: in depth up to 4 m, to the side where a border ray of slope 1/2 has
// gone 4 m.
TEST(SeenVolume, OfOneCameraEndsAtAStatedDistance) {
  const auto box = seenVolume({cameraAt({0, 0, 0}, {1, 0, 0})});
  ASSERT_TRUE(box.has_value());
  EXPECT_NEAR(box->max.x(), kSingleCameraRange, 1e-9);
  EXPECT_GT(box->min.x(), 0.0);
  EXPECT_NEAR(box->max.y(), 0.5 * kSingleCameraRange / std::sqrt(1.25), 1e-9);
  EXPECT_NEAR(box->min.y(), -box->max.y(), 1e-9);
  const Camera twice = cameraAt({0, 0, 0}, {1, 0, 0});
  const auto same = seenVolume({twice, twice}); // no distance between them
  ASSERT_TRUE(same.has_value());
  EXPECT_NEAR(same->max.x(), kSingleCameraRange, 1e-9);
}

// 0.1 m apart and parallel: 20 times that.
TEST(SeenVolume, OfParallelCamerasEndsByTheirDistance) {
  const auto box =
      seenVolume({cameraAt({0, 0.05, 0}, {1, 0.05, 0}), cameraAt({0, -0.05, 0}, {1, -0.05, 0})});
  ASSERT_TRUE(box.has_value());
  EXPECT_NEAR(box->max.x(), 2.0, 0.07);
}

TEST(SeenVolume, IsWhatEachSeesWhereNoTwoSeeAnythingTogether) {
  const auto box = seenVolume({cameraAt({1, 0, 0}, {2, 0, 0}), cameraAt({-1, 0, 0}, {-2, 0, 0})});
  ASSERT_TRUE(box.has_value());
  EXPECT_GT(box->max.x(), 2.0);
  EXPECT_LT(box->min.x(), -2.0);
}

TEST(SeenVolume, NeedsAUsableCamera) {
  EXPECT_FALSE(seenVolume({}).has_value());
  EXPECT_FALSE(seenVolume({Camera{}}).has_value());
  CameraRig rig = twoCameras();
  const auto expected = seenVolume(rig);
  rig.emplace_back(); // no size yet
  rig.push_back(rig.front());
  rig.back().cameraFromWorld.translation().setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(seenVolume(rig), expected);
}

TEST(WorldBox, ContainsItsFacesAndWhatIsWithinAMargin) {
  const WorldBox box{{0.0, -1.0, 2.0}, {1.0, 1.0, 3.0}};
  EXPECT_EQ(box.center(), Eigen::Vector3d(0.5, 0.0, 2.5));
  EXPECT_EQ(box.halfSize(), Eigen::Vector3d(0.5, 1.0, 0.5));
  EXPECT_TRUE(box.contains(box.min));
  EXPECT_TRUE(box.contains(box.max));
  EXPECT_FALSE(box.contains({0.5, 0.0, 3.01}));
  EXPECT_TRUE(box.contains({0.5, 0.0, 3.01}, 0.02));
  EXPECT_FALSE(box.contains({-0.03, 0.0, 2.5}, 0.02));
}

} // namespace
} // namespace dewpoint::tests
