// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/rotation_vector.h"
#include "core/setup/calibration/floor_from_board.h"
#include "core/setup/calibration/moved_world.h"
#include "tests/calibration/board_scene.h"
#include "tests/ui/calibration/board/shown_board.h"

#include <gtest/gtest.h>

#include <memory>

namespace dewpoint::tests {
namespace {

/// The cameras of a shown board, calibrated, in a world that has nothing to do with the floor.
class FloorFromBoardTest : public testing::Test {
protected:
  FloorFromBoardTest() {
    for (std::size_t k = 0; k < project_.cameras.size(); ++k) {
      project_.cameras[k].camera = shown_.cameras[k];
    }
    project_ = withMovedWorld(
        project_, {1.0, geometry::rotationFromVector({0.3, -0.2, 0.9}), {1.0, 2.0, 3.0}});
  }
  FrameSet frames(int place) const {
    FrameSet set;
    for (std::size_t k = 0; k < shown_.cameras.size(); ++k) {
      set.frames.push_back(std::make_shared<const Frame>(Frame{0, {}, shown_.picture(k, place)}));
    }
    return set;
  }

  test::ShownBoard shown_;
  Project project_ = shown_.project();
};

TEST_F(FloorFromBoardTest, TheBoardLiesOnTheFloorAfterwards) {
  const int place = 0; // not tilted, 0.45 m in front of the cameras
  const auto found = withFloorFromBoard(project_, shown_.board, frames(place));
  ASSERT_TRUE(found) << found.error().detail;
  EXPECT_EQ(found->cameraCount, 2U);
  EXPECT_LT(found->rmsPx, 0.5);
  EXPECT_EQ(found->project.worldRecord.floorOrigin, CalibrationOrigin::Board);
  for (const ProjectCamera& camera : found->project.cameras) {
    EXPECT_NEAR(camera.camera.center().z(), 0.45, 0.005); // above the floor, and as far as it was
    EXPECT_LT(camera.camera.opticalAxis().z(), -0.99);    // looks down
  }
  const double apart =
      (found->project.cameras[0].camera.center() - found->project.cameras[1].camera.center())
          .norm();
  EXPECT_NEAR(apart, 0.1, 1e-9); // a rigid motion
}

TEST_F(FloorFromBoardTest, SaysThatThereIsNoBoard) {
  FrameSet set = frames(0);
  for (FramePtr& frame : set.frames) {
    frame = std::make_shared<const Frame>(Frame{0, {}, cv::Mat(300, 400, CV_8UC3, cv::Scalar())});
  }
  const auto found = withFloorFromBoard(project_, shown_.board, set);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::NotFound);
}

TEST_F(FloorFromBoardTest, RefusesImagesOfAnotherSize) {
  project_.cameras[1].camera.intrinsics.width = 800;
  const auto found = withFloorFromBoard(project_, shown_.board, frames(0));
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::Mismatch);
  EXPECT_EQ(found.error().field, "right");
}

} // namespace
} // namespace dewpoint::tests
