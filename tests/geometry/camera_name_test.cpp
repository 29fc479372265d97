// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/camera_name.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

CameraRig named(const std::vector<std::string>& names) {
  CameraRig rig;
  for (const std::string& name : names) {
    rig.emplace_back().name = name;
  }
  return rig;
}

TEST(CameraName, NumbersCountFromOne) {
  EXPECT_EQ(defaultCameraName(0), "camera 1");
}

TEST(CameraName, TheFreeOneIsTheFirstFromTheSizeOnThatNoneHas) {
  EXPECT_EQ(unusedCameraName({}), "camera 1");
  EXPECT_EQ(unusedCameraName(named({"left", "right"})), "camera 3");
  EXPECT_EQ(unusedCameraName(named({"left", "camera 3", "camera 4"})), "camera 5");
}

TEST(CameraName, TheFirstNumberAndTheWordsMayBeOthers) {
  const auto german = [](std::size_t number) { return "Kamera " + std::to_string(number + 1); };
  const CameraRig rig = named({"left", "right", "Kamera 3", "Kamera 5"});
  EXPECT_EQ(unusedCameraName(rig, 2, german), "Kamera 4");
  EXPECT_EQ(unusedCameraName(rig, 4, german), "Kamera 6");
  EXPECT_EQ(unusedCameraName(rig, 2, defaultCameraName), "camera 3");
}

TEST(CameraName, IsTheNumberWhereThereIsNone) {
  Camera camera;
  EXPECT_EQ(nameOrNumber(camera, 2), "camera 3");
  camera.name = "door";
  EXPECT_EQ(nameOrNumber(camera, 2), "door");
}

} // namespace
} // namespace dewpoint::tests
