// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/watch/camera_agreement_watch.h"
#include "core/tracking/catalog/method_catalog.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

CameraRig watchedCameras() {
  CameraRig rig(2);
  rig[0].name = "left";
  rig[0].cameraFromWorld = lookAt({1.0, 0.2, 0.6}, {0.0, 0.0, 0.0});
  rig[1].cameraFromWorld = lookAt({-1.1, 0.3, 0.7}, {0.0, 0.0, 0.0});
  return rig;
}

TEST(CameraAgreementWatch, ARigInMillimetersIsKnownBeforeTheFirstFrame) {
  CameraRig rig = watchedCameras();
  const CameraMotionWatch motion(rig);
  EXPECT_TRUE(CameraAgreementWatch(rig, motion).disagreements(methodFamily("dewpoint")).empty());
  for (Camera& camera : rig) {
    camera.cameraFromWorld.translation() *= 1000.0;
  }
  CameraAgreementWatch watch(rig, motion);
  ASSERT_EQ(watch.disagreements(methodFamily("dewpoint")).size(), 1U);
  EXPECT_TRUE(watch.disagreements(methodFamily("histogram")).empty()); // boxes need no calibration
  watch.setCameras(watchedCameras());
  EXPECT_TRUE(watch.disagreements(methodFamily("dewpoint")).empty());
}

} // namespace
} // namespace dewpoint::tests
