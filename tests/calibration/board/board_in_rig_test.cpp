// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board_in_rig.h"
#include "core/geometry/projector.h"
#include "tests/calibration/board_scene.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace dewpoint::tests {
namespace {

/// Three cameras around a board on the floor.
class BoardInRigTest : public testing::Test {
protected:
  BoardInRigTest() {
    for (int k = 0; k < 3; ++k) {
      Camera camera = testCamera();
      camera.name = "camera " + std::to_string(k + 1);
      camera.cameraFromWorld = Eigen::Translation3d(0.15 * (k - 1), 0.0, 0.1 * k) *
                               Eigen::AngleAxisd(0.15 * (k - 1), Eigen::Vector3d::UnitY());
      rig_.push_back(camera);
    }
    truth_ = boardAt(board_, {0.02, 0.03, 0.8}, 0.5, -0.3, 0.2);
  }

  /// The corners that a camera sees, moved by `offset`.
  BoardDetection seenBy(std::size_t camera, const Eigen::Vector2d& offset = {0.0, 0.0}) const {
    BoardDetection seen;
    for (int id = 0; id < board_.cornerCount(); ++id) {
      if (const auto pixel = Projector(rig_[camera]).project(truth_ * board_.corner(id))) {
        seen.ids.push_back(id);
        seen.pixels.push_back(*pixel + offset);
      }
    }
    return seen;
  }
  static double difference(const Eigen::Isometry3d& one, const Eigen::Isometry3d& other) {
    return (one.matrix() - other.matrix()).norm();
  }

  BoardDescription board_ = parseBoard("charuco:7x5:0.03:0.022:DICT_4X4_50").value();
  CameraRig rig_;
  Eigen::Isometry3d truth_;
};

TEST_F(BoardInRigTest, IsFoundFromAllCamerasThatSeeIt) {
  const auto found = locateBoardInRig(board_, rig_, {seenBy(0), std::nullopt, seenBy(2)});
  ASSERT_TRUE(found) << found.error().detail;
  EXPECT_LT(difference(found->worldFromBoard, truth_), 1e-5);
  EXPECT_EQ(found->cameras, (std::vector<std::size_t>{0, 2}));
  EXPECT_LT(found->rmsPx, 1e-3);
}

TEST_F(BoardInRigTest, OneCameraIsEnough) {
  const auto found = locateBoardInRig(board_, rig_, {std::nullopt, seenBy(1), std::nullopt});
  ASSERT_TRUE(found) << found.error().detail;
  EXPECT_LT(difference(found->worldFromBoard, truth_), 1e-5);
}

TEST_F(BoardInRigTest, ASymmetricBoardMayBeNumberedFromEitherEnd) {
  board_ = parseBoard("chessboard:7x5:0.03").value(); // odd by odd inner corners: two ways
  ASSERT_EQ(board_.symmetryOrder(), 2);
  truth_ = boardAt(board_, {0.02, 0.03, 0.8}, 0.5, -0.3, 0.2);
  const auto found =
      locateBoardInRig(board_, rig_, {seenBy(0), rotated(seenBy(1), board_, 2), seenBy(2)});
  ASSERT_TRUE(found) << found.error().detail;
  EXPECT_EQ(found->cameras.size(), 3U);
  EXPECT_LT(found->rmsPx, 1e-3);
}

TEST_F(BoardInRigTest, ACalibrationThatDoesNotFitIsNamed) {
  rig_[2].cameraFromWorld.translation().x() += 0.2; // moved since it was calibrated
  const auto seen = seenBy(2);
  rig_[2].cameraFromWorld.translation().x() -= 0.2;
  const auto found = locateBoardInRig(board_, rig_, {seenBy(0), seenBy(1), seen});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::Mismatch);
}

TEST_F(BoardInRigTest, WithoutABoardThereIsNone) {
  const auto found = locateBoardInRig(board_, rig_, {std::nullopt, std::nullopt, std::nullopt});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::NotFound);
}

} // namespace
} // namespace dewpoint::tests
