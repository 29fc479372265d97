// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/extrinsics_from_board.h"
#include "tests/calibration/board_views.h"

#include <algorithm>

namespace dewpoint::tests {
namespace {

/// Four cameras around a place 1.5 m away, looking at it.
CameraRig ring() {
  CameraRig rig;
  for (int k = 0; k < 4; ++k) {
    Camera camera = testCamera();
    camera.name = "camera " + std::to_string(k + 1);
    const double angle = 0.5 * k - 0.75;
    camera.cameraFromWorld =
        lookAt({1.5 * std::sin(angle), -1.5 * std::cos(angle), 0.9 + 0.1 * k}, {0.0, 0.0, 0.3});
    rig.push_back(camera);
  }
  return rig;
}

/// The board held up between the cameras in various places; instant 0 lies flat at the origin.
Eigen::Isometry3d boardInRoom(const BoardDescription& board, std::uint32_t number) {
  Eigen::Isometry3d pose = worldFromFlatBoard();
  if (number > 0) {
    const RandomStream random(4, number, 0, RandomPurpose::Simulation);
    const auto u = random.uniform3(0);
    const auto v = random.uniform3(1);
    // Standing upright, facing the cameras (-Y), then turned.
    pose.linear() = (Eigen::AngleAxisd(0.8 * v[0] - 0.4, Eigen::Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(-1.2 + 0.6 * v[1], Eigen::Vector3d::UnitX()) *
                     Eigen::AngleAxisd(2.0 * v[2] - 1.0, Eigen::Vector3d::UnitZ()))
                        .toRotationMatrix();
    pose.translation() = Eigen::Vector3d(0.6 * u[0] - 0.3, 0.5 * u[1] - 0.25, 0.5 * u[2]) -
                         pose.linear() * board.center();
  }
  return pose;
}

ExtrinsicsRequest extrinsicsRequest(const char* board, double sigmaPx) {
  ExtrinsicsRequest request;
  request.board = boardOf(board);
  for (const Camera& camera : ring()) {
    BoardCamera seen{camera, {}};
    seen.camera.cameraFromWorld.setIdentity(); // not known
    for (std::uint32_t number = 0; number < 15; ++number) {
      auto view =
          viewOf(request.board, camera, camera.cameraFromWorld * boardInRoom(request.board, number),
                 sigmaPx, number);
      if (static_cast<int>(view.detection.ids.size()) == request.board.cornerCount()) {
        seen.views.push_back(std::move(view));
      }
    }
    request.cameras.push_back(std::move(seen));
  }
  request.worldDefiningInstant = 0;
  return request;
}

void expectRing(const ExtrinsicsResult& result, double meters) {
  const CameraRig truth = ring();
  for (std::size_t k = 0; k < truth.size(); ++k) {
    EXPECT_LT((result.cameras[k].center() - truth[k].center()).norm(), meters) << k;
    EXPECT_LT((result.cameras[k].opticalAxis() - truth[k].opticalAxis()).norm(), 2.0 * meters) << k;
  }
}

TEST(ExtrinsicsFromBoard, ExactCornersGiveExactPoses) {
  const auto result = calibrateExtrinsics(extrinsicsRequest("chessboard:9x6:0.025", 0.0));
  ASSERT_TRUE(result) << errorSentence(result.error());
  expectRing(*result, 1e-5);
  EXPECT_LT(result->rmsPx, 1e-3);
}

TEST(ExtrinsicsFromBoard, NoisyCornersStayNear) {
  const auto result = calibrateExtrinsics(extrinsicsRequest("chessboard:9x6:0.025", 0.2));
  ASSERT_TRUE(result) << errorSentence(result.error());
  // The world hangs on one small board at instant 0, 1.5 m away: it may tilt by half a degree. How
  // the cameras stand to each other is known better.
  expectRing(*result, 0.02);
  const CameraRig truth = ring();
  for (std::size_t k = 1; k < truth.size(); ++k) {
    EXPECT_NEAR((result->cameras[k].center() - result->cameras[0].center()).norm(),
                (truth[k].center() - truth[0].center()).norm(), 0.003);
  }
  EXPECT_NEAR(result->rmsPx, 0.2 * std::sqrt(2.0), 0.02);
  EXPECT_GT(result->cameraFits[3].centerSigma, 0.0);
  EXPECT_LT(result->cameraFits[3].centerSigma, 0.01);
}

// The board is small in the middle of the images: it does not tell how the lens bends rays at the
// edges.
TEST(ExtrinsicsFromBoard, LensesThatTheViewsDoNotDetermineAreKept) {
  auto request = extrinsicsRequest("chessboard:9x6:0.025", 0.5);
  request.refinesIntrinsics = true;
  for (BoardCamera& camera : request.cameras) {
    camera.intrinsicsErrorPx = 1.0;
  }
  const auto result = calibrateExtrinsics(request);
  ASSERT_TRUE(result) << errorSentence(result.error());
  for (std::size_t k = 0; k < result->cameras.size(); ++k) {
    EXPECT_FALSE(result->cameraFits[k].isLensRefined) << k;
    EXPECT_EQ(result->cameras[k].intrinsics.focalX, request.cameras[k].camera.intrinsics.focalX);
  }
  ASSERT_EQ(result->notices.size(), 4U);
  EXPECT_NE(result->notices[0].find("keeps its intrinsics"), std::string::npos)
      << result->notices[0];
}

TEST(ExtrinsicsFromBoard, SymmetricBoardIsCountedAlike) {
  auto request = extrinsicsRequest("chessboard:7x5:0.03", 0.1);
  for (std::size_t camera = 1; camera < 4; ++camera) {
    for (std::size_t k = camera; k < request.cameras[camera].views.size(); k += 2) {
      auto& detection = request.cameras[camera].views[k].detection;
      detection = rotated(detection, request.board, 2); // as a camera that is turned may count
    }
  }
  const auto result = calibrateExtrinsics(request);
  ASSERT_TRUE(result) << errorSentence(result.error());
  expectRing(*result, 0.01);
  EXPECT_TRUE(result->notices.empty());
}

TEST(ExtrinsicsFromBoard, BadViewsAreLeftOutAndNamed) {
  auto request = extrinsicsRequest("chessboard:9x6:0.025", 0.1);
  auto& view = request.cameras[2].views[3];
  for (auto& pixel : view.detection.pixels) {
    pixel += Eigen::Vector2d(25.0, -10.0); // a frame of another instant
  }
  const auto result = calibrateExtrinsics(request);
  ASSERT_TRUE(result) << errorSentence(result.error());
  expectRing(*result, 0.01);
  const auto& fits = result->cameraFits[2].views;
  const auto left = std::ranges::find(fits, false, &ViewFit::isUsed);
  ASSERT_NE(left, fits.end());
  EXPECT_EQ(left->name, view.name);
}

TEST(ExtrinsicsFromBoard, UnconnectedCamerasAreNamed) {
  auto request = extrinsicsRequest("chessboard:9x6:0.025", 0.1);
  for (auto& view : request.cameras[3].views) {
    view.instant += 1000;
  }
  const auto result = calibrateExtrinsics(request);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::Undetermined);
  EXPECT_NE(result.error().detail.find("'camera 4'"), std::string::npos) << result.error().detail;
}

TEST(ExtrinsicsFromBoard, TheFirstCameraKeepsAGivenPose) {
  auto request = extrinsicsRequest("chessboard:9x6:0.025", 0.0);
  request.worldDefiningInstant.reset();
  request.cameras[0].camera.cameraFromWorld = ring()[0].cameraFromWorld;
  const auto result = calibrateExtrinsics(request);
  ASSERT_TRUE(result) << errorSentence(result.error());
  expectRing(*result, 1e-5);
}

TEST(ExtrinsicsFromBoard, CancelStops) {
  const auto stopped = calibrateExtrinsics(extrinsicsRequest("chessboard:9x6:0.025", 0.1),
                                           [](CalibrationStage, double) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::Canceled);
}

} // namespace
} // namespace dewpoint::tests
