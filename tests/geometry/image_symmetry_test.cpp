// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/image_symmetry.h"
#include "core/geometry/projector.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

Camera bentCamera() {
  Camera camera;
  camera.intrinsics = {640, 480, 610.0, 590.0, 330.0, 228.0};
  camera.distortion = {-0.2, 0.05, 0.003, -0.002, 0.001};
  camera.cameraFromWorld = lookAt({1.0, -2.0, 1.5}, {0.0, 0.5, 0.4}, {0, 0, 1}, 0.2);
  return camera;
}

TEST(ImageSymmetry, CornersGoWhereATurnedPictureHasThem) {
  // The upper left pixel of 640 x 480 is the upper right one after a quarter turn clockwise.
  EXPECT_EQ(transformed({90, false}, {0.0, 0.0}, 640, 480), Eigen::Vector2d(479, 0));
  EXPECT_EQ(transformed({180, false}, {0.0, 0.0}, 640, 480), Eigen::Vector2d(639, 479));
  EXPECT_EQ(transformed({270, false}, {0.0, 0.0}, 640, 480), Eigen::Vector2d(0, 639));
  EXPECT_EQ(transformed({0, true}, {0.0, 0.0}, 640, 480), Eigen::Vector2d(639, 0));
  EXPECT_EQ(transformed({90, true}, {0.0, 0.0}, 640, 480), Eigen::Vector2d(0, 0));
}

TEST(ImageSymmetry, ATurnedCameraSeesEveryPointAtItsTurnedPixel) {
  const Camera camera = bentCamera();
  for (const int degrees : {0, 90, 180, 270}) {
    const ImageSymmetry turn{degrees, false};
    const Camera other = transformed(turn, camera);
    EXPECT_EQ(other.intrinsics.width, degrees % 180 == 0 ? 640 : 480);
    for (const Eigen::Vector3d& point :
         {Eigen::Vector3d(0, 0.5, 0.4), Eigen::Vector3d(0.5, 0.1, 0), Eigen::Vector3d(-1, 1, 1)}) {
      const auto before = Projector(camera).project(point);
      const auto after = Projector(other).project(point);
      ASSERT_TRUE(before && after);
      EXPECT_LT((transformed(turn, *before, 640, 480) - *after).norm(), 1e-9) << degrees;
    }
    EXPECT_LT((other.center() - camera.center()).norm(), 1e-12);
  }
}

TEST(ImageSymmetry, AMirroredLensSeesMirroredRays) {
  Camera camera = bentCamera();
  camera.cameraFromWorld = Eigen::Isometry3d::Identity();
  const Camera other = transformed({0, true}, camera);
  const auto before = Projector(camera).project({0.3, 0.2, 1.0});
  const auto after = Projector(other).project({-0.3, 0.2, 1.0});
  ASSERT_TRUE(before && after);
  EXPECT_LT((transformed({0, true}, *before, 640, 480) - *after).norm(), 1e-9);
}

TEST(ImageSymmetry, CombinesAsTheOneAfterTheOther) {
  const Eigen::Vector2d pixel(17.0, 5.0);
  for (const ImageSymmetry& first : imageSymmetries()) {
    for (const ImageSymmetry& second : imageSymmetries()) {
      const bool lies = first.rotateDegrees % 180 != 0;
      const Eigen::Vector2d step = transformed(first, pixel, 40, 30);
      const Eigen::Vector2d both = transformed(second, step, lies ? 30 : 40, lies ? 40 : 30);
      EXPECT_EQ(transformed(combined(first, second), pixel, 40, 30), both);
    }
  }
}

} // namespace
} // namespace dewpoint::tests
