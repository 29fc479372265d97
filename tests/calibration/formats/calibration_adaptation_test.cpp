// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/calibration_adaptation.h"
#include "core/geometry/image_symmetry.h"
#include "core/geometry/projector.h"

#include <gtest/gtest.h>

#include <functional>

namespace dewpoint::tests {
namespace {

Camera calibrated(int width, int height) {
  Camera camera;
  camera.name = "left";
  camera.intrinsics = {width, height, 900.0, 910.0, 0.5 * width + 3.25, 0.5 * height - 7.5};
  camera.distortion = {-0.1, 0.02, 0.001, -0.002, 0.0};
  camera.cameraFromWorld = lookAt({0.3, -2.0, 1.0}, {0.0, 0.0, 0.0});
  return camera;
}

/// Projects points with the fitted camera, and compares them with where `moved` takes the pixels of
/// the calibrated one.
void expectPixelsMove(const Camera& before, const Camera& after,
                      const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& moved) {
  for (const Eigen::Vector3d& point :
       {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(0.3, 0.2, 0.1),
        Eigen::Vector3d(-0.4, 0.5, -0.2)}) {
    const auto was = Projector(before).project(point);
    const auto is = Projector(after).project(point);
    ASSERT_TRUE(was && is);
    EXPECT_LT((*is - moved(*was)).norm(), 1e-9);
  }
}

TEST(CalibrationAdaptation, ACropShiftsThePrincipalPointByHalfTheDifference) {
  const Camera before = calibrated(1920, 1088);
  const auto after = fittedToSize(before, 1900, 1080, SizeFit::Crop);
  ASSERT_TRUE(after) << errorSentence(after.error());
  EXPECT_EQ(after->intrinsics.width, 1900);
  EXPECT_EQ(after->intrinsics.height, 1080);
  expectPixelsMove(before, *after, [](const Eigen::Vector2d& pixel) {
    return Eigen::Vector2d(pixel.x() - 10.0, pixel.y() - 4.0);
  });
  EXPECT_EQ(sizeFitSentence(before, *after, SizeFit::Crop),
            "left: cropped from 1920 x 1088 to 1900 x 1080 pixels.");
}

TEST(CalibrationAdaptation, ATrimmedImageKeepsItsPixels) {
  const Camera before = calibrated(1920, 1088);
  const auto after = fittedToSize(before, 1920, 1080, SizeFit::Trim);
  ASSERT_TRUE(after) << errorSentence(after.error());
  EXPECT_EQ(after->intrinsics.height, 1080);
  expectPixelsMove(before, *after, [](const Eigen::Vector2d& pixel) { return pixel; });
}

TEST(CalibrationAdaptation, ScalingKeepsTheEdgesOfTheImage) {
  const Camera before = calibrated(1920, 1088);
  const auto after = fittedToSize(before, 960, 272, SizeFit::Scale);
  ASSERT_TRUE(after) << errorSentence(after.error());
  expectPixelsMove(before, *after, [](const Eigen::Vector2d& pixel) {
    return Eigen::Vector2d((pixel.x() + 0.5) / 2.0 - 0.5, (pixel.y() + 0.5) / 4.0 - 0.5);
  });
}

TEST(CalibrationAdaptation, ARotationTurnsThePoseToo) {
  const Camera before = calibrated(1920, 1080);
  for (const auto& [fit, degrees] :
       {std::pair(SizeFit::Rotate90, 90), std::pair(SizeFit::Rotate270, 270)}) {
    const auto after = fittedToSize(before, 1080, 1920, fit);
    ASSERT_TRUE(after) << errorSentence(after.error());
    EXPECT_EQ(after->intrinsics.width, 1080);
    EXPECT_LT((after->center() - before.center()).norm(), 1e-12);
    expectPixelsMove(before, *after, [degrees = degrees](const Eigen::Vector2d& pixel) {
      return transformed({degrees, false}, pixel, 1920, 1080);
    });
  }
  EXPECT_EQ(fittedToSize(before, 1080, 1900, SizeFit::Rotate90).error().code, ErrorCode::Mismatch);
}

TEST(CalibrationAdaptation, ThePrincipalPointStaysInTheImage) {
  EXPECT_EQ(fittedToSize(calibrated(1920, 1088), 100, 100, SizeFit::Trim).error().code,
            ErrorCode::Mismatch);
}

TEST(CalibrationAdaptation, FitsHaveNames) {
  EXPECT_EQ(parseSizeFit("crop"), SizeFit::Crop);
  EXPECT_EQ(parseSizeFit("rotate-270"), SizeFit::Rotate270);
  EXPECT_FALSE(parseSizeFit("stretch"));
}

TEST(CalibrationAdaptation, CamerasGetOtherNames) {
  const auto names = parseCameraRenaming({"left=camera 2", "camera 2=camera 1"});
  ASSERT_TRUE(names) << errorSentence(names.error());
  CameraRig rig(3);
  for (std::size_t k = 0; k < rig.size(); ++k) {
    rig[k].name = "camera " + std::to_string(k + 1);
  }
  const CameraRig whole = rig;
  ASSERT_TRUE(renameCameras(rig, *names, "rig.toml"));
  EXPECT_EQ(quotedNames(rig), "'camera 2', 'left', 'camera 3'");

  rig = whole;
  const auto missing = renameCameras(rig, {{"left", "cam"}}, "rig.toml");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().field, "cam");
  EXPECT_NE(missing.error().detail.find("'camera 1', 'camera 2', 'camera 3'"), std::string::npos);
  EXPECT_FALSE(renameCameras(rig, {{"camera 3", "camera 1"}}, "rig.toml")); // twice then

  for (const char* wrong : {"left", "=camera 1", "left="}) {
    EXPECT_EQ(parseCameraRenaming({wrong}).error().field, "--map") << wrong;
  }
  EXPECT_FALSE(parseCameraRenaming({"left=a", "left=b"}));
}

} // namespace
} // namespace dewpoint::tests
