// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board_detection.h"
#include "core/calibration/board/board_picture.h"
#include "core/geometry/projector.h"
#include "tests/calibration/board_views.h"

#include <opencv2/aruco/charuco.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cstdio>

namespace dewpoint::tests {
namespace {

struct Accuracy {
  int pictures = 0;
  int found = 0;
  std::size_t corners = 0;
  double medianPx = 0.0;
  double worstPx = 0.0;
  Eigen::Vector2d biasPx = Eigen::Vector2d::Zero();
};

/// Camera noise of 2 gray levels, and a slight blur as every lens has.
cv::Mat photographed(cv::Mat picture, std::uint32_t number) {
  cv::GaussianBlur(picture, picture, {0, 0}, 0.6);
  const RandomStream random(5, number, 0, RandomPurpose::Noise);
  for (int row = 0; row < picture.rows; ++row) {
    for (int column = 0; column < picture.cols; ++column) {
      auto& pixel = picture.at<unsigned char>(row, column);
      const auto index = static_cast<std::uint32_t>(row * picture.cols + column);
      pixel = cv::saturate_cast<unsigned char>(pixel + 2.0F * random.normal3(index)[0]);
    }
  }
  return picture;
}

Accuracy measure(const char* text, DetectionEffort effort, int count) {
  const BoardDescription board = boardOf(text);
  const Camera camera = testCamera();
  const BoardDetector detector(board);
  Accuracy result;
  std::vector<double> errors;
  for (const auto& pose : variedPoses(board, camera, count, 3)) {
    const auto number = static_cast<std::uint32_t>(result.pictures++);
    const auto found =
        detector.detect(photographed(renderBoard(board, camera, pose), number), effort);
    if (!found) {
      continue;
    }
    ++result.found;
    Camera placed = camera;
    placed.cameraFromWorld = pose;
    const Projector projector(placed);
    for (std::size_t k = 0; k < found->ids.size(); ++k) {
      const Eigen::Vector2d off =
          found->pixels[k] - *projector.project(board.corner(found->ids[k]));
      errors.push_back(off.norm());
      result.biasPx += off;
    }
  }
  std::ranges::sort(errors);
  result.corners = errors.size();
  result.medianPx = errors.empty() ? 1e9 : errors[errors.size() / 2];
  result.worstPx = errors.empty() ? 1e9 : errors.back();
  result.biasPx /= static_cast<double>(std::max<std::size_t>(1, errors.size()));
  const auto record = [](const char* what, auto value) {
    ::testing::Test::RecordProperty(what, std::to_string(value));
  };
  record("found", result.found);
  record("corners", result.corners);
  record("median_px", result.medianPx);
  record("worst_px", result.worstPx);
  record("bias_x_px", result.biasPx.x());
  record("bias_y_px", result.biasPx.y());
  return result;
}

/// The bars: issue 5, "a self-test on rendered boards".
void expectExact(const Accuracy& accuracy) {
  EXPECT_LE(accuracy.medianPx, 0.06);
  EXPECT_LE(std::abs(accuracy.biasPx.x()), 0.02);
  EXPECT_LE(std::abs(accuracy.biasPx.y()), 0.02);
  EXPECT_LE(accuracy.worstPx, 1.0); // no corner taken for another
}

TEST(BoardDetection, ChessboardExact) {
  const auto accuracy = measure("chessboard:9x6:0.025", DetectionEffort::Exact, 12);
  expectExact(accuracy);
  EXPECT_EQ(accuracy.found, 12);
}

TEST(BoardDetection, ChessboardLive) {
  const auto accuracy = measure("chessboard:9x6:0.025", DetectionEffort::Live, 12);
  expectExact(accuracy);
  EXPECT_GE(accuracy.found, 11);
}

TEST(BoardDetection, Charuco) {
  const auto accuracy = measure("charuco:7x5:0.054:0.04:DICT_4X4_50", DetectionEffort::Exact, 12);
  expectExact(accuracy);
  EXPECT_GE(accuracy.corners, 12U * 24U * 95U / 100U);
}

TEST(BoardDetection, CharucoOfEvenRowsOfOlderSoftware) {
  const char* text = "charuco:7x6:0.054:0.04:DICT_5X5_100:legacy";
  const auto accuracy = measure(text, DetectionEffort::Live, 10);
  expectExact(accuracy);
  EXPECT_GE(accuracy.corners, 10U * 30U * 95U / 100U);
}

TEST(BoardDetection, InvertedCharuco) {
  const char* text = "charuco:4x5:0.054:0.0405:DICT_4X4_1000:inverted";
  const auto accuracy = measure(text, DetectionEffort::Exact, 10);
  expectExact(accuracy);
  EXPECT_GE(accuracy.corners, 10U * 12U * 9U / 10U);
}

TEST(BoardDetection, ChessboardIsCountedFromItsFirstSquareHoweverItIsTurned) {
  const BoardDescription board = boardOf("chessboard:9x6:0.025");
  const Camera camera = testCamera();
  const BoardDetector detector(board);
  for (const double roll : {0.0, 1.5, 3.1, -1.6}) {
    const auto pose = boardAt(board, {0.0, 0.0, 0.5}, 0.2, -0.2, roll);
    const auto found = detector.detect(renderBoard(board, camera, pose, 4), DetectionEffort::Live);
    ASSERT_TRUE(found) << roll;
    Camera placed = camera;
    placed.cameraFromWorld = pose;
    EXPECT_LT((found->pixels[0] - *Projector(placed).project(board.corner(0))).norm(), 0.5) << roll;
  }
}

TEST(BoardDetection, SymmetricChessboardRunsToTheRight) {
  const BoardDescription board = boardOf("chessboard:7x5:0.025");
  const Camera camera = testCamera();
  for (const double roll : {0.1, 3.2}) {
    const auto pose = boardAt(board, {0.0, 0.0, 0.4}, 0.2, -0.2, roll);
    const auto found =
        BoardDetector(board).detect(renderBoard(board, camera, pose, 4), DetectionEffort::Live);
    ASSERT_TRUE(found);
    EXPECT_LT(found->pixels.front().x(), found->pixels[6].x());
    const auto half = rotated(*found, board, 2);
    EXPECT_EQ(half.pixels.front(), found->pixels.back());
  }
}

TEST(BoardDetection, HiddenCornersAreLeftOut) {
  const BoardDescription board = boardOf("charuco:7x5:0.054:0.04:DICT_4X4_50");
  const Camera camera = testCamera();
  const auto pose = boardAt(board, {0.0, 0.0, 0.6}, 0.1, 0.1);
  cv::Mat picture = renderBoard(board, camera, pose, 4);
  cv::rectangle(picture, {300, 0, 340, 480}, cv::Scalar(120), cv::FILLED);
  const auto found = BoardDetector(board).detect(picture, DetectionEffort::Exact);
  ASSERT_TRUE(found);
  EXPECT_LT(found->ids.size(), 24U);
  EXPECT_GE(found->ids.size(), 8U);
}

TEST(BoardDetection, BlurShowsInTheEdges) {
  const BoardDescription board = boardOf("chessboard:9x6:0.025");
  const auto picture =
      renderBoard(board, testCamera(), boardAt(board, {0.0, 0.0, 0.5}, 0.2, 0.2), 4);
  cv::Mat blurred;
  cv::GaussianBlur(picture, blurred, {0, 0}, 3.0);
  const BoardDetector detector(board);
  const auto sharp = detector.detect(picture, DetectionEffort::Live);
  const auto soft = detector.detect(blurred, DetectionEffort::Live);
  ASSERT_TRUE(sharp && soft);
  EXPECT_LT(sharp->edgeWidthPx, 2.0);
  EXPECT_GT(soft->edgeWidthPx, 5.0); // a Gaussian edge: contrast / slope = sigma sqrt(2 pi) = 7.5
  EXPECT_LT(*motionBetween(*sharp, *soft), 0.2);
}

// The layout against OpenCV's own: 4.6 draws the first square black whatever the number of rows.
TEST(BoardPicture, CharucoAsOpenCvDrawsIt) {
  for (const auto& [columns, rows] : {std::pair(5, 4), std::pair(4, 7)}) {
    const BoardDescription board = boardOf(("charuco:" + std::to_string(columns) + "x" +
                                            std::to_string(rows) + ":0.08:0.06:DICT_4X4_50")
                                               .c_str());
    const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50);
    cv::Mat theirs;
    cv::aruco::CharucoBoard::create(columns, rows, 0.08F, 0.06F, dictionary)
        ->draw({columns * 80 + 80, rows * 80 + 80}, theirs, 40);
    const cv::Mat ours = drawBoard(board, 80);
    ASSERT_EQ(ours.size(), theirs.size());
    EXPECT_LT(cv::norm(ours, theirs, cv::NORM_L1) / 255.0,
              0.001 * static_cast<double>(ours.total()));
  }
}

TEST(BoardDetection, NothingWithoutABoard) {
  const cv::Mat gray(480, 640, CV_8UC1, cv::Scalar(128));
  EXPECT_FALSE(BoardDetector(boardOf("chessboard:9x6:0.025")).detect(gray, DetectionEffort::Live));
  EXPECT_FALSE(BoardDetector(boardOf("charuco:7x5:0.054:0.04:DICT_4X4_50"))
                   .detect(gray, DetectionEffort::Exact));
}

} // namespace
} // namespace dewpoint::tests
