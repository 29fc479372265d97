// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/image_margins.h"
#include "core/geometry/projector.h"
#include "tests/geometry/webcam.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

constexpr ImageMargins kCut{10, 20, 30, 40};

TEST(ImageMargins, ACroppedCameraSeesEveryPointAtItsShiftedPixel) {
  const Camera camera = webcam();
  const Camera cropped = recropped(camera, {}, kCut);
  EXPECT_EQ(cropped.intrinsics.width, camera.intrinsics.width - 40);
  EXPECT_EQ(cropped.intrinsics.height, camera.intrinsics.height - 60);
  const Eigen::Vector3d point = camera.cameraFromWorld.inverse() * Eigen::Vector3d(0.1, -0.05, 1.0);
  const auto before = Projector(camera).project(point);
  const auto after = Projector(cropped).project(point);
  ASSERT_TRUE(before && after);
  EXPECT_TRUE(after->isApprox(*before - Eigen::Vector2d(10.0, 20.0), 1e-12));
}

TEST(ImageMargins, CroppingCanBeTakenBack) {
  const Camera camera = webcam();
  EXPECT_EQ(recropped(recropped(camera, {}, kCut), kCut, {}), camera);
  EXPECT_EQ(recropped(recropped(camera, {}, kCut), kCut, {1, 2, 3, 4}),
            recropped(camera, {}, {1, 2, 3, 4}));
}

TEST(ImageMargins, RotateAndMirrorWithTheImage) {
  EXPECT_EQ(transformed({90, false}, kCut), (ImageMargins{40, 10, 20, 30}));
  EXPECT_EQ(transformed({180, false}, kCut), (ImageMargins{30, 40, 10, 20}));
  EXPECT_EQ(transformed({0, true}, kCut), (ImageMargins{30, 20, 10, 40}));
  EXPECT_EQ(transformed({90, true}, kCut), (ImageMargins{20, 10, 40, 30}));
}

TEST(ImageMargins, TransformingACroppedCameraIsCroppingTheTransformedOne) {
  const Camera camera = webcam();
  for (const ImageSymmetry& symmetry : imageSymmetries()) {
    const Camera one = transformed(symmetry, recropped(camera, {}, kCut));
    const Camera other = recropped(transformed(symmetry, camera), {}, transformed(symmetry, kCut));
    EXPECT_EQ(one.intrinsics.width, other.intrinsics.width);
    EXPECT_EQ(one.intrinsics.height, other.intrinsics.height);
    EXPECT_DOUBLE_EQ(one.intrinsics.centerX, other.intrinsics.centerX);
    EXPECT_DOUBLE_EQ(one.intrinsics.centerY, other.intrinsics.centerY);
  }
}

} // namespace
} // namespace dewpoint::tests
