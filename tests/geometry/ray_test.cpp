// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/ray.h"
#include "tests/geometry/webcam.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace dewpoint::tests {
namespace {

/// Every pixel of a grid over the image must come back when a point of its ray is projected.
void expectRoundTrip(const Camera& camera) {
  const Projector projector(camera);
  const Unprojector unprojector(camera);
  for (int column = -20; column <= 340; column += 40) {
    for (int row = -20; row <= 260; row += 40) {
      const Eigen::Vector2d pixel(column, row);
      const auto ray = unprojector.ray(pixel);
      ASSERT_TRUE(ray.has_value()) << pixel.transpose();
      EXPECT_NEAR(ray->direction.norm(), 1.0, 1e-14);
      EXPECT_LT((ray->origin - camera.center()).norm(), 1e-14);
      const auto back = projector.project(ray->origin + 1.7 * ray->direction);
      ASSERT_TRUE(back.has_value()) << pixel.transpose();
      EXPECT_LT((*back - pixel).norm(), 1e-8) << pixel.transpose(); // the stated 1e-9 and rounding
    }
  }
}

TEST(Unprojector, InvertsThePinhole) {
  expectRoundTrip(webcam({}));
}

TEST(Unprojector, InvertsFiveCoefficients) {
  expectRoundTrip(webcam({-0.28, 0.07, 0.0012, -0.0008, 0.004}));
}

TEST(Unprojector, InvertsTheRationalModel) {
  expectRoundTrip(webcam({0.12, 0.03, -0.0007, 0.0011, 0.002, 0.2, 0.04, 0.003}));
}

TEST(Unprojector, InvertsTheFisheye) {
  Camera camera = webcam({-0.02, 0.004, -0.001, 0.0002});
  camera.lens = LensModel::Fisheye;
  camera.intrinsics.focalX = camera.intrinsics.focalY = 170.0; // 78 degrees at the corners
  expectRoundTrip(camera);
}

TEST(Unprojector, FollowsThePinholeByHand) {
  Camera camera; // axes are the world's
  camera.intrinsics = {320, 240, 100.0, 200.0, 160.0, 120.0};
  const auto direction = Unprojector(camera).worldDirection({170.0, 110.0}); // (0.1, -0.05, 1)
  ASSERT_TRUE(direction.has_value());
  EXPECT_LT((*direction - Eigen::Vector3d(0.1, -0.05, 1.0).normalized()).norm(), 1e-15);
}

TEST(Unprojector, RefusesPixelsTheLensCannotMake) {
  // r (1 - s) grows up to s = 1/3, where it is 0.3849: 38.49 px at a focal length of 100 px.
  Camera camera;
  camera.intrinsics = {320, 240, 100.0, 100.0, 160.0, 120.0};
  camera.distortion = {-1.0};
  const Unprojector unprojector(camera);
  EXPECT_TRUE(unprojector.worldDirection({160.0 + 38.4, 120.0}).has_value());
  EXPECT_FALSE(unprojector.worldDirection({160.0 + 38.6, 120.0}).has_value());
  EXPECT_FALSE(unprojector.worldDirection({500.0, 120.0}).has_value());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(unprojector.worldDirection({nan, 120.0}).has_value());
}

TEST(NearestPoint, IsTheMiddleOfTwoSkewRays) {
  // Along x at z = 0, and along y at z = 2 through x = 3: closest at (3, 0, 0) and (3, 0, 2).
  const auto point = nearestPoint({{{0, 0, 0}, {1, 0, 0}}, {{3, -5, 2}, {0, 1, 0}}});
  ASSERT_TRUE(point.has_value());
  EXPECT_LT((*point - Eigen::Vector3d(3, 0, 1)).norm(), 1e-12);
}

TEST(NearestPoint, NeedsTwoRaysThatMeetInFront) {
  const Ray alongX{{0, 0, 0}, {1, 0, 0}};
  EXPECT_FALSE(nearestPoint({}).has_value());
  EXPECT_FALSE(nearestPoint({alongX}).has_value());
  EXPECT_FALSE(nearestPoint({alongX, {{0, 1, 0}, {1, 0, 0}}}).has_value()) << "parallel";
  EXPECT_FALSE(nearestPoint({alongX, {{-3, -5, 0}, {0, 1, 0}}}).has_value()) << "behind the first";
}

TEST(DistanceToRay, CountsFromTheOriginBehindIt) {
  const Ray alongX{{1, 0, 0}, {1, 0, 0}};
  EXPECT_DOUBLE_EQ(distanceToRay(alongX, {5, 3, 4}), 5.0);
  EXPECT_DOUBLE_EQ(distanceToRay(alongX, {-3, 3, 0}), 5.0); // (4, 3) away from the origin
}

} // namespace
} // namespace dewpoint::tests
