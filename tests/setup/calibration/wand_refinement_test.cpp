// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/angle.h"
#include "core/setup/calibration/wand_refinement.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

/// Cameras that were said to be off by 0.12 m at most, and are known to so many meters now.
WandRefinement refinedTo(double positionErrorFromCameras95) {
  WandRefinement refinement;
  refinement.options.initialPositionError = 0.12;
  refinement.accuracy->positionErrorFromCameras95 = positionErrorFromCameras95;
  return refinement;
}

TEST(WandRefinement, LessAccurateThanBeforeSaysTooLittle) {
  EXPECT_FALSE(isInaccurate(refinedTo(0.003)));
  EXPECT_FALSE(isInaccurate(refinedTo(0.12))); // as well known as before
  EXPECT_TRUE(isInaccurate(refinedTo(0.13)));
}

TEST(WandRefinement, WithoutAnAssessmentNothingIsSaidAgainstIt) {
  WandRefinement refinement = refinedTo(0.13);
  refinement.accuracy = failure(ErrorCode::Undetermined, "", "accuracy", "");
  EXPECT_FALSE(isInaccurate(refinement));
  EXPECT_FALSE(isDoubtful(refinement));
}

TEST(WandRefinement, AFaultOrTooLittleMakesItDoubtful) {
  EXPECT_FALSE(isDoubtful(refinedTo(0.003)));
  EXPECT_TRUE(isDoubtful(refinedTo(0.13)));
  WandRefinement faulty = refinedTo(0.003);
  faulty.result.faults = {{.fault = CalibrationFault::CamerasSwapped, .cameras = {0, 1}}};
  EXPECT_FALSE(isInaccurate(faulty));
  EXPECT_TRUE(isDoubtful(faulty));
}

TEST(WandRefinement, WhatTheFormerCamerasExplainAsWellIsNotNeeded) {
  WandRefinement refinement = refinedTo(0.003);
  refinement.accuracy->leftOutPointCount = 100;
  refinement.accuracy->leftOutRmsPx = 0.4;
  EXPECT_FALSE(isUnnecessary(refinement)); // not compared
  refinement.beforePx = 0.5;
  EXPECT_FALSE(isUnnecessary(refinement));
  EXPECT_FALSE(isDoubtful(refinement));
  refinement.beforePx = 0.35;
  EXPECT_TRUE(isUnnecessary(refinement));
  EXPECT_TRUE(isDoubtful(refinement));
  EXPECT_NE(unnecessaryRefinementText(refinement).find("0.35 px"), std::string::npos);
}

/// A refinement of calibrated cameras, whose new positions are known to 6 mm.
WandRefinement ofCalibratedCameras() {
  WandRefinement refinement = refinedTo(0.003);
  refinement.accuracy->leftOutPointCount = 100;
  refinement.accuracy->leftOutRmsPx = 0.4;
  refinement.accuracy->cameras = {{0.004, 0.001}, {0.006, 0.001}};
  refinement.wasCalibratedBefore = true;
  refinement.beforePx = 0.7; // worse than the new ones, but not as of a camera that was moved
  return refinement;
}

TEST(WandRefinement, CamerasThatWereKnownBetterAreKept) {
  WandRefinement refinement = ofCalibratedCameras();
  EXPECT_FALSE(areOldCamerasMoreAccurate(
      refinement)); // their error is not recorded, and no motion is missing
  refinement.beforeError = 0.0015;
  EXPECT_TRUE(areOldCamerasMoreAccurate(refinement));
  EXPECT_TRUE(isDoubtful(refinement));
  EXPECT_FALSE(isUnnecessary(refinement));
  EXPECT_EQ(oldCamerasMoreAccurateText(refinement),
            "the old camera positions are known more accurately (+-1.5 mm) than the new ones (+-6 "
            "mm): keep the old ones");
  refinement.beforeError = 0.02;
  EXPECT_FALSE(areOldCamerasMoreAccurate(refinement));
  refinement.beforeError.reset();
  refinement.gaps = {
      {.missingMotion = MissingMotion::OffThePlane, .cameras = {0}, .severity = 0.8}};
  EXPECT_TRUE(areOldCamerasMoreAccurate(refinement));
  refinement.gaps[0].severity = 0.2;
  EXPECT_FALSE(areOldCamerasMoreAccurate(refinement));
}

TEST(WandRefinement, CamerasThatTheImagesContradictAreReplaced) {
  WandRefinement refinement = ofCalibratedCameras();
  refinement.beforeError = 0.0015;
  refinement.beforePx = 4.0; // one was moved after its calibration
  EXPECT_FALSE(areOldCamerasMoreAccurate(refinement));
  refinement.beforePx.reset(); // not compared
  EXPECT_FALSE(areOldCamerasMoreAccurate(refinement));
  refinement = ofCalibratedCameras();
  refinement.beforeError = 0.0015;
  refinement.wasCalibratedBefore = false; // placed by hand
  EXPECT_FALSE(areOldCamerasMoreAccurate(refinement));
}

/// Cameras that the refinement rotates about x by these angles, degrees.
WandRefinement rotatedBy(const std::vector<double>& degrees) {
  WandRefinement refinement;
  for (std::size_t k = 0; k < degrees.size(); ++k) {
    Camera camera;
    camera.name = "camera " + std::to_string(k + 1);
    refinement.camerasBefore.push_back(camera);
    camera.cameraFromWorld.linear() =
        Eigen::AngleAxisd(degrees[k] * kDegree, Eigen::Vector3d::UnitX()).toRotationMatrix();
    refinement.result.cameras.push_back(camera);
  }
  return refinement;
}

TEST(WandRefinement, ACameraThatWasFarOffIsNamed) {
  const WandRefinement refinement = rotatedBy({0.2, 2.1, 0.3, 0.1});
  const auto found = farOffCameras(refinement);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].camera, 1U);
  EXPECT_NE(farOffText(found[0], refinement.camerasBefore)
                .find("camera 2 was far off: the refinement "
                      "rotates it by 2.1 degrees"),
            std::string::npos)
      << farOffText(found[0], refinement.camerasBefore);
}

TEST(WandRefinement, CamerasThatAllMoveAlikeAreNotNamed) {
  EXPECT_TRUE(farOffCameras(rotatedBy({4.0, 5.0, 6.0, 5.5})).empty()); // placed by hand
  EXPECT_TRUE(farOffCameras(rotatedBy({0.1, 0.6, 0.1})).empty());      // as calibrations are
  EXPECT_TRUE(farOffCameras(rotatedBy({0.1, 3.0})).empty());           // two cannot tell
}

} // namespace
} // namespace dewpoint::tests
