// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_motion/agreement/disagreement_sentence.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(DisagreementSentence, SaysWhatIsWrongAndWhatToDo) {
  CameraRig rig(2);
  rig[0].name = "left";
  EXPECT_EQ(describeDisagreement({.fault = CameraFault::Swapped, .cameras = {0, 1}}, rig),
            "left and camera 2 seem to be swapped; exchange their images in the project file");
  EXPECT_EQ(
      describeDisagreement({.fault = CameraFault::Late, .cameras = {1}, .delay = 0.2}, rig),
      "the images of camera 2 are about 200 ms late; add 0.200 to its late_by in the project file");
  EXPECT_EQ(describeDisagreement({.fault = CameraFault::Unit, .metersPerUnit = 0.001}, rig),
            "the calibration seems to be in units of 0.001 m; it must be in meters");
  EXPECT_EQ(describeDisagreement({.fault = CameraFault::Unknown, .cameras = {1}}, rig),
            "camera 2 does not agree with the other cameras; calibrate it again");
}

} // namespace
} // namespace dewpoint::tests
