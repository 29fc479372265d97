// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/camera_agreement_watch.h"
#include "core/tracking/catalog/method_catalog.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

CameraRig twoCameras() {
  CameraRig rig(2);
  rig[0].name = "left";
  rig[0].cameraFromWorld = lookAt({1.0, 0.2, 0.6}, {0.0, 0.0, 0.0});
  rig[1].cameraFromWorld = lookAt({-1.1, 0.3, 0.7}, {0.0, 0.0, 0.0});
  return rig;
}

TEST(CameraAgreementWatch, ARigInMillimetersIsKnownBeforeTheFirstFrame) {
  CameraRig rig = twoCameras();
  const CameraMotionWatch motion(rig);
  EXPECT_TRUE(CameraAgreementWatch(rig, motion).found(methodFamily("dewpoint")).empty());
  for (Camera& camera : rig) {
    camera.cameraFromWorld.translation() *= 1000.0;
  }
  CameraAgreementWatch watch(rig, motion);
  ASSERT_EQ(watch.found(methodFamily("dewpoint")).size(), 1U);
  EXPECT_TRUE(watch.found(methodFamily("histogram")).empty()); // boxes need no calibration
  watch.setCameras(twoCameras());
  EXPECT_TRUE(watch.found(methodFamily("dewpoint")).empty());
}

TEST(CameraAgreementWatch, TheCommandLineSaysWhatIsWrongAndWhatToDo) {
  const CameraRig rig = twoCameras();
  EXPECT_EQ(disagreementSentence({.fault = CameraFault::Swapped, .cameras = {0, 1}}, rig),
            "left and camera 2 seem to be swapped; exchange their images in the project file");
  EXPECT_EQ(disagreementSentence({.fault = CameraFault::Late, .cameras = {1}, .delay = 0.2}, rig),
            "camera 2 is about 200 ms late; add 0.200 to its late_by in the project file");
  EXPECT_EQ(disagreementSentence({.fault = CameraFault::Unit, .scale = 0.001}, rig),
            "the positions of the cameras seem to be in units of 0.001 m; they are expected in "
            "meters");
  EXPECT_EQ(disagreementSentence({.fault = CameraFault::Unknown, .cameras = {1}}, rig),
            "camera 2 does not agree with the other cameras; calibrate it again");
}

} // namespace
} // namespace dewpoint::tests
