// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/new_project/project_recording.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(ProjectRecording, IsTheFileAsTheProjectTakesIt) {
  ProjectCamera camera;
  camera.camera.name = "door";
  camera.camera.intrinsics.width = 640;
  camera.camera.intrinsics.height = 480;
  camera.source = SourceKind::Video;
  camera.location = "/recordings/door.mp4";
  camera.rotateDegrees = 90;
  camera.isMirrored = true;
  camera.captureTimeFile = "/recordings/door.csv";
  camera.delay = 0.02;
  const RecordedCamera recorded = setup::recordedCamera(camera);
  EXPECT_EQ(recorded.name, "door");
  EXPECT_EQ(recorded.kind, RecordedCamera::Kind::Video);
  EXPECT_EQ(recorded.path, "/recordings/door.mp4");
  EXPECT_EQ(recorded.rotateDegrees, 90);
  EXPECT_TRUE(recorded.isMirrored);
  EXPECT_EQ(recorded.width, 640);
  EXPECT_EQ(recorded.height, 480);
  EXPECT_EQ(recorded.timesFile, "/recordings/door.csv");
  EXPECT_EQ(recorded.delaySeconds, 0.02);

  camera.source = SourceKind::Images;
  EXPECT_EQ(setup::recordedCamera(camera).kind, RecordedCamera::Kind::Images);
}

} // namespace
} // namespace dewpoint::tests
