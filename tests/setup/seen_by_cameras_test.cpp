// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/seen_volume.h"
#include "core/project/project_rig.h"
#include "core/setup/seen_by_cameras.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

Camera lookingFrom(const Eigen::Vector3d& position) {
  Camera camera;
  camera.name = "camera";
  camera.intrinsics = {640, 480, 700.0, 700.0, 319.5, 239.5};
  camera.cameraFromWorld = lookAt(position, {0.0, 0.0, 0.5});
  return camera;
}

TEST(SeenByCameras, IsTheVolumeOfTheProjectsRig) {
  Project project;
  EXPECT_FALSE(setup::volumeSeenByCameras(project));
  for (const Eigen::Vector3d& position :
       {Eigen::Vector3d(0.0, -2.0, 0.5), Eigen::Vector3d(2.0, 0.0, 0.5)}) {
    project.cameras.emplace_back().camera = lookingFrom(position);
  }
  const auto volume = setup::volumeSeenByCameras(project);
  ASSERT_TRUE(volume);
  EXPECT_TRUE(volume->contains({0.0, 0.0, 0.5})) << "where both look";
  EXPECT_FALSE(volume->contains({0.0, -3.0, 0.5})) << "behind the first camera";
  EXPECT_EQ(volume, seenVolume(rigOf(project)));
}

} // namespace
} // namespace dewpoint::tests
