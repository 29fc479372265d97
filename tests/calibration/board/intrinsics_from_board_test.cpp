// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/intrinsics_from_board.h"
#include "tests/calibration/board_views.h"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cstdio>

namespace dewpoint::tests {
namespace {

IntrinsicsRequest intrinsicsRequest(const Camera& camera, double sigmaPx, int count) {
  IntrinsicsRequest request;
  request.board = boardOf("chessboard:9x6:0.025");
  request.width = camera.intrinsics.width;
  request.height = camera.intrinsics.height;
  std::uint32_t number = 0;
  for (const auto& pose : variedPoses(request.board, camera, count, 9)) {
    request.views.push_back(viewOf(request.board, camera, pose, sigmaPx, number++));
  }
  return request;
}

TEST(IntrinsicsFromBoard, TruthLiesWithinTheStatedDeviations) {
  const Camera truth = testCamera();
  const auto result = calibrateIntrinsics(intrinsicsRequest(truth, 0.1, 15));
  ASSERT_TRUE(result) << errorSentence(result.error());
  // Two coordinates of sigma 0.1 px each, less the part the 98 parameters take.
  EXPECT_NEAR(result->rmsPx, 0.1 * std::sqrt(2.0), 0.01);
  ASSERT_EQ(result->parameters[0].name, "f"); // pixels are square here
  const double trueValues[] = {truth.intrinsics.focalX,
                               truth.intrinsics.centerX,
                               truth.intrinsics.centerY,
                               -0.18,
                               0.06,
                               0.001,
                               -0.0008,
                               0.0};
  for (std::size_t k = 0; k < result->parameters.size(); ++k) {
    const auto& parameter = result->parameters[k];
    EXPECT_GT(parameter.sigma, 0.0);
    EXPECT_LT(std::abs(parameter.value - trueValues[k]), 3.5 * parameter.sigma) << parameter.name;
  }
  EXPECT_LT(result->maxProjectionSigmaPx, 5.0); // in the corners, where hardly a view reached
  EXPECT_GT(result->coverage.coveredFraction(), 0.7);
}

TEST(IntrinsicsFromBoard, PixelsThatAreNotSquareAreNoticed) {
  Camera truth = testCamera();
  truth.intrinsics.focalY *= 0.97;
  const auto result = calibrateIntrinsics(intrinsicsRequest(truth, 0.1, 15));
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->camera.intrinsics.focalY / result->camera.intrinsics.focalX, 0.97, 0.002);
}

TEST(IntrinsicsFromBoard, BadViewsAreLeftOutAndNamed) {
  const Camera truth = testCamera();
  auto request = intrinsicsRequest(truth, 0.1, 12);
  for (auto& pixel : request.views[4].detection.pixels) {
    pixel.x() += 0.06 * (pixel.y() - 240.0) * (pixel.x() > 320.0 ? 1.0 : -1.0); // a bent board
  }
  const auto result = calibrateIntrinsics(request);
  ASSERT_TRUE(result);
  int left = 0;
  for (const ViewFit& view : result->views) {
    if (!view.isUsed) {
      ++left;
      EXPECT_EQ(view.name, "view 4");
      EXPECT_NE(view.reason.find("px off"), std::string::npos);
    }
  }
  EXPECT_EQ(left, 1);
  EXPECT_NEAR(result->camera.intrinsics.focalX, truth.intrinsics.focalX, 2.0);
}

TEST(IntrinsicsFromBoard, EightCoefficientsAndFisheye) {
  Camera wide = testCamera();
  wide.distortion = {0.3, 0.05, 0.0005, -0.0004, 0.002, 0.55, 0.12, 0.008};
  auto request = intrinsicsRequest(wide, 0.05, 20);
  request.model = IntrinsicsModel::EightCoefficients;
  const auto rational = calibrateIntrinsics(request);
  ASSERT_TRUE(rational) << errorSentence(rational.error());
  EXPECT_NEAR(rational->rmsPx, 0.05 * std::sqrt(2.0), 0.01);
  EXPECT_NEAR(rational->camera.intrinsics.focalX, wide.intrinsics.focalX, 3.0);

  Camera fish = testCamera();
  fish.lens = LensModel::Fisheye;
  fish.intrinsics.focalX = fish.intrinsics.focalY = 300.0;
  fish.distortion = {0.02, -0.01, 0.004, -0.001};
  request = intrinsicsRequest(fish, 0.05, 20);
  request.model = IntrinsicsModel::Fisheye;
  const auto fisheye = calibrateIntrinsics(request);
  ASSERT_TRUE(fisheye) << errorSentence(fisheye.error());
  EXPECT_NEAR(fisheye->rmsPx, 0.05 * std::sqrt(2.0), 0.01);
  EXPECT_NEAR(fisheye->camera.intrinsics.focalX, 300.0, 1.0);
  EXPECT_EQ(fisheye->camera.lens, LensModel::Fisheye);
}

TEST(IntrinsicsFromBoard, TooFewViewsAndCancel) {
  auto request = intrinsicsRequest(testCamera(), 0.1, 12);
  const auto stopped = calibrateIntrinsics(request, [](CalibrationStage, double) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::Canceled);
  request.views.resize(2);
  const auto few = calibrateIntrinsics(request);
  ASSERT_FALSE(few);
  EXPECT_EQ(few.error().code, ErrorCode::Undetermined);
}

// Counted along the wrong side, corners 6 and 7 of a row of nine become the ends of different rows.
TEST(IntrinsicsFromBoard, AWrongNumberOfCornersIsNamed) {
  auto request = intrinsicsRequest(testCamera(), 0.1, 15);
  request.board = boardOf("chessboard:6x9:0.025");
  const auto result = calibrateIntrinsics(request);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::BadValue);
  EXPECT_EQ(result.error().field, "board");
}

// Published: opencv/opencv samples/data/left_intrinsics.yml (0dd31c3b).
TEST(IntrinsicsFromBoard, OpenCvLeft13) {
  const auto folder = dataFolder("opencv_left13");
  if (folder.empty()) {
    GTEST_SKIP() << "DEWPOINT_DATA has no opencv_left13";
  }
  IntrinsicsRequest request;
  request.board = boardOf("chessboard:9x6:0.025");
  request.width = 640;
  request.height = 480;
  const BoardDetector detector(request.board);
  for (int k = 1; k <= 14; ++k) {
    const std::string name = (k < 10 ? "left0" : "left") + std::to_string(k) + ".jpg";
    const cv::Mat picture = cv::imread((folder / name).string(), cv::IMREAD_GRAYSCALE);
    if (const auto found =
            picture.empty() ? std::nullopt : detector.detect(picture, DetectionEffort::Sample)) {
      request.views.push_back({name, k, *found});
    }
  }
  ASSERT_EQ(request.views.size(), 13U);
  const auto result = calibrateIntrinsics(request);
  ASSERT_TRUE(result) << errorSentence(result.error());
  EXPECT_NEAR(result->rmsPx, 0.39259, 0.001);
  const auto& camera = result->camera;
  EXPECT_NEAR(camera.intrinsics.focalX, 535.916, 0.05);
  EXPECT_NEAR(camera.intrinsics.centerX, 342.283, 0.05);
  EXPECT_NEAR(camera.intrinsics.centerY, 235.571, 0.05);
  const double lens[] = {-0.26637, -0.03859, 0.00178, -0.00028, 0.23839};
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(camera.distortion[k], lens[k], 0.001) << k;
  }
  const double perView[] = {.19296546, 1.18204820, .17338619, .19341731, .15957409,
                            .17968391, .23098949,  .24195240, .29626766, .16718487,
                            .20200261, .38103953,  .17440134};
  for (std::size_t k = 0; k < 13; ++k) {
    EXPECT_NEAR(result->views[k].rmsPx, perView[k], 0.005) << result->views[k].name;
  }
  EXPECT_TRUE(result->views[1].isDoubtful); // named, not left out: 1.2 px is little of 640 px
}

} // namespace
} // namespace dewpoint::tests
