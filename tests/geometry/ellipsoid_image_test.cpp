// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/ellipsoid_image.h"
#include "core/geometry/sphere_image.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <numbers>

namespace dewpoint::tests {
namespace {

Camera camera() {
  Camera camera;
  camera.intrinsics = {640, 480, 610.0, 590.0, 318.25, 241.5};
  camera.cameraFromWorld = lookAt({0.5, -0.4, 0.6}, {0.4, 0.5, 0.1}, {0, 0, 1}, 0.2);
  return camera;
}

/// Semi-axes of 12, 6 and 3 cm, rotated, off the optical axis.
Ellipsoid tilted() {
  const Eigen::Matrix3d axes(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()));
  const Eigen::Vector3d squares(0.12 * 0.12, 0.06 * 0.06, 0.03 * 0.03);
  return {{0.55, 0.45, 0.2}, axes * squares.asDiagonal() * axes.transpose()};
}

// A ray from the camera's center hits the ellipsoid where its distance from the center, in
// semi-axes, is at most one: counted over a fine raster, without anything of the projector.
TEST(EllipsoidImage, IsTheAreaThatRaysHit) {
  const Camera view = camera();
  const Ellipsoid solid = tilted();
  const auto image = EllipsoidProjector(view).project(solid);
  ASSERT_TRUE(image);
  const Eigen::Matrix3d inverse = solid.extent.inverse();
  const Eigen::Matrix3d worldFromCamera = view.cameraFromWorld.linear().transpose();
  const Eigen::Vector3d eye = view.center() - solid.center;
  double area = 0.0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  constexpr double kStep = 0.25; // pixels
  for (double row = 0.0; row < 480.0; row += kStep) {
    for (double column = 0.0; column < 640.0; column += kStep) {
      const Eigen::Vector3d way =
          worldFromCamera *
          Eigen::Vector3d((column - view.intrinsics.centerX) / view.intrinsics.focalX,
                          (row - view.intrinsics.centerY) / view.intrinsics.focalY, 1.0);
      const double a = way.dot(inverse * way);
      const double b = way.dot(inverse * eye);
      const double c = eye.dot(inverse * eye) - 1.0;
      if (b * b - a * c >= 0.0) {
        const Eigen::Vector2d pixel(column, row);
        area += kStep * kStep;
        first += kStep * kStep * pixel;
        second += kStep * kStep * pixel * pixel.transpose();
      }
    }
  }
  const Eigen::Vector2d center = first / area;
  const Eigen::Matrix2d moments = second / area - center * center.transpose();
  EXPECT_NEAR(image->area(), area, 2e-3 * area);
  EXPECT_LT((image->center - center).norm(), 0.05);
  EXPECT_LT((0.25 * image->extent - moments).norm(), 2e-3 * moments.norm());
}

TEST(EllipsoidImage, OfABallIsThatOfASphere) {
  const Camera view = camera();
  const double radius = 0.05;
  const Eigen::Vector3d center(0.35, 0.4, 0.15);
  const auto ellipse = EllipsoidProjector(view).project({center, ballExtent(radius)});
  const auto sphere = SphereProjector(view).project(center, radius);
  ASSERT_TRUE(ellipse && sphere);
  EXPECT_LT((ellipse->center - sphere->center).norm(), 1e-6);
  EXPECT_NEAR(ellipse->area(), std::numbers::pi * sphere->radius * sphere->radius, 0.01);
}

TEST(EllipsoidImage, IsNothingBehindTheCamera) {
  const Camera view = camera();
  const Eigen::Vector3d behind = view.center() - 0.5 * view.opticalAxis();
  const Eigen::Vector3d around = view.center() + 0.05 * view.opticalAxis();
  const EllipsoidProjector projector(view);
  EXPECT_FALSE(projector.project({behind, 1e-4 * Eigen::Matrix3d::Identity()}));
  EXPECT_FALSE(projector.project({around, 1e-2 * Eigen::Matrix3d::Identity()}));
}

// A ball of the same volume: the third root of 12 x 6 x 3 cm is 6 cm.
TEST(EllipsoidImage, HasTheRadiusOfABallOfItsVolume) {
  EXPECT_NEAR(tilted().radius(), 0.06, 1e-9);
  EXPECT_NEAR((Ellipsoid{Eigen::Vector3d::Zero(), ballExtent(0.035)}.radius()), 0.035, 1e-12);
}

} // namespace
} // namespace dewpoint::tests
