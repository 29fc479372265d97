// SPDX-License-Identifier: GPL-3.0-or-later
// Why a board was not found in an image.
#include "core/calibration/board/board_miss.h"
#include "core/calibration/board/board_picture.h"
#include "tests/calibration/board_views.h"

#include <opencv2/imgproc.hpp>

namespace dewpoint::tests {
namespace {

cv::Mat boardFacing(const BoardDescription& board, double depth) {
  return renderBoard(board, testCamera(), boardAt(board, {0.0, 0.0, depth}, 0.1, 0.1), 4);
}

TEST(BoardMiss, AnImageWithoutABoardHasNoReason) {
  const BoardDetector detector(boardOf("chessboard:9x6:0.025"));
  const cv::Mat plain(480, 640, CV_8UC3, cv::Scalar(90, 90, 90));
  const BoardMiss miss = diagnoseMissedBoard(detector, plain);
  EXPECT_EQ(miss, BoardMiss());
  EXPECT_EQ(missReasonText(miss), "");
}

TEST(BoardMiss, ABlurredImageIsNamed) {
  const BoardDescription board = boardOf("chessboard:9x6:0.025");
  cv::Mat image = boardFacing(board, 0.35);
  cv::GaussianBlur(image, image, {0, 0}, 10.0);
  const BoardMiss miss = diagnoseMissedBoard(BoardDetector(board), image);
  ASSERT_EQ(miss.reason, BoardMiss::Reason::Blurred) << missReasonText(miss);
  EXPECT_GT(miss.edgeWidthPx, 10.0); // a Gaussian step of 10 px: 25 px of contrast by slope
  EXPECT_LT(miss.edgeWidthPx, 60.0);
  EXPECT_NE(missReasonText(miss).find("blurred, edges of"), std::string::npos);
}

TEST(BoardMiss, ABoardFarAwayIsTooSmall) {
  const BoardDescription board = boardOf("chessboard:9x6:0.025");
  const BoardMiss miss = diagnoseMissedBoard(BoardDetector(board), boardFacing(board, 2.0));
  ASSERT_EQ(miss.reason, BoardMiss::Reason::TooSmall) << missReasonText(miss);
  EXPECT_NEAR(miss.squareSizePx, 0.85 * 640 * 0.025 / 2.0, 1.5);
}

TEST(BoardMiss, AHiddenCharucoBoardShowsTooFewCorners) {
  const BoardDescription board = boardOf("charuco:7x5:0.054:0.04:DICT_4X4_50");
  const Camera camera = testCamera();
  const auto pose = boardAt(board, {0.0, 0.0, 0.5}, 0.0, 0.0);
  cv::Mat image = renderBoard(board, camera, pose, 4);
  // A hand hides all but three squares of the first two rows: two corners remain.
  Camera placed = camera;
  placed.cameraFromWorld = pose;
  const auto edge = Projector(placed).project(board.corner(2)); // the right end of square 3
  const auto below = Projector(placed).project(board.corner(board.cornerColumns()));
  ASSERT_TRUE(edge && below);
  const int right = static_cast<int>(edge->x());
  const int low = static_cast<int>(below->y());
  image.colRange(right, image.cols).setTo(128);
  image.rowRange(std::min(low, image.rows), image.rows).setTo(128);
  ASSERT_FALSE(BoardDetector(board).detect(image, DetectionEffort::Exact));
  const BoardMiss miss = diagnoseMissedBoard(BoardDetector(board), image);
  ASSERT_EQ(miss.reason, BoardMiss::Reason::TooFewCorners) << missReasonText(miss);
  EXPECT_GE(miss.cornerCount, 1);
  EXPECT_LE(miss.cornerCount, 3);
}

} // namespace
} // namespace dewpoint::tests
