// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/camera_name.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(CameraName, IsTheNumberWhereThereIsNone) {
  Camera camera;
  EXPECT_EQ(geometry::nameOrNumber(camera, 2), "camera 3");
  camera.name = "door";
  EXPECT_EQ(geometry::nameOrNumber(camera, 2), "door");
}

TEST(CameraName, AFreeOneIsNoneOfTheRig) {
  CameraRig rig(2);
  EXPECT_EQ(geometry::freeCameraName(rig), "camera 3");
  rig[0].name = "camera 3";
  EXPECT_EQ(geometry::freeCameraName(rig), "camera 4");
}

} // namespace
} // namespace dewpoint::tests
