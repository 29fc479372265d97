// SPDX-License-Identifier: GPL-3.0-or-later
// Which board images show, found without knowing it.
#include "core/calibration/board/board_guess.h"
#include "core/calibration/board/board_picture.h"
#include "tests/calibration/board_views.h"

#include <opencv2/imgproc.hpp>

namespace dewpoint::tests {
namespace {

/// Views of a board in perspective, as a camera with a lens sees it, slightly blurred.
std::vector<cv::Mat> viewsOfBoard(const char* text, int count = 6) {
  const BoardDescription board = boardOf(text);
  const Camera camera = testCamera();
  std::vector<cv::Mat> images;
  for (const auto& pose : variedPoses(board, camera, count, 11)) {
    cv::Mat image = renderBoard(board, camera, pose, 3);
    cv::GaussianBlur(image, image, {0, 0}, 0.6);
    images.push_back(image);
  }
  return images;
}

/// The most likely board in images; one that found nothing if there is none.
BoardGuess bestGuess(const std::vector<cv::Mat>& images,
                     const char* requested = "chessboard:10x8:0.03") {
  const auto guesses = guessBoards(images, boardOf(requested));
  EXPECT_TRUE(guesses.has_value());
  return !guesses || guesses->empty() ? BoardGuess{} : guesses->front();
}

std::string bestText(const char* shown, const char* requested = "chessboard:10x8:0.03") {
  const BoardGuess best = bestGuess(viewsOfBoard(shown), requested);
  EXPECT_GE(best.imageCount, 4) << shown;
  EXPECT_EQ(best.searchedImageCount, 6) << shown;
  EXPECT_FALSE(best.isMirrored) << shown;
  return boardText(best.board);
}

TEST(BoardGuess, ChessboardsOfAnySize) {
  EXPECT_EQ(bestText("chessboard:9x6:0.025"), "chessboard:9x6:0.03"); // the length of the requested
  EXPECT_EQ(bestText("chessboard:7x5:0.025"), "chessboard:7x5:0.03");
  EXPECT_EQ(bestText("chessboard:9x6:0.025", "charuco:7x5:0.04:0.03:DICT_4X4_50"),
            "chessboard:9x6:0.04");
}

TEST(BoardGuess, CharucoBoardsOfAnyDictionary) {
  EXPECT_EQ(bestText("charuco:7x5:0.054:0.0405:DICT_4X4_50"),
            "charuco:7x5:0.03:0.0225:DICT_4X4_50");
  // The smaller dictionaries begin with the same markers.
  EXPECT_EQ(bestText("charuco:5x7:0.05:0.04:DICT_6X6_250"), "charuco:5x7:0.03:0.024:DICT_6X6_50");
  EXPECT_EQ(bestText("charuco:6x5:0.05:0.0375:DICT_ARUCO_ORIGINAL"),
            "charuco:6x5:0.03:0.0225:DICT_ARUCO_ORIGINAL");
}

TEST(BoardGuess, LegacyAndInverted) {
  EXPECT_EQ(bestText("charuco:7x6:0.054:0.0405:DICT_5X5_100:legacy"),
            "charuco:7x6:0.03:0.0225:DICT_5X5_50:legacy");
  EXPECT_EQ(bestText("charuco:4x5:0.054:0.0405:DICT_4X4_1000:inverted"),
            "charuco:4x5:0.03:0.0225:DICT_4X4_50:inverted");
}

TEST(BoardGuess, WhatWasRequestedRightIsKept) {
  // Only the number of columns was wrong.
  EXPECT_EQ(
      bestText("charuco:7x5:0.054:0.04:DICT_4X4_1000", "charuco:8x5:0.054:0.04:DICT_4X4_1000"),
      "charuco:7x5:0.054:0.04:DICT_4X4_1000");
  EXPECT_EQ(bestText("chessboard:9x6:0.025", "chessboard:6x9:0.025"), "chessboard:6x9:0.025");
}

TEST(BoardGuess, MirroredImages) {
  auto images = viewsOfBoard("charuco:7x5:0.054:0.0405:DICT_4X4_50");
  for (cv::Mat& image : images) {
    cv::flip(image.clone(), image, 1);
  }
  const BoardGuess best = bestGuess(images);
  EXPECT_TRUE(best.isMirrored);
  EXPECT_EQ(boardText(best.board), "charuco:7x5:0.03:0.0225:DICT_4X4_50");
  EXPECT_NE(guessAdviceSentence(best).find("mirror"), std::string::npos);
}

TEST(BoardGuess, AFewOfManyImagesAreEnough) {
  std::vector<cv::Mat> images(6, cv::Mat(480, 640, CV_8UC1, cv::Scalar(90)));
  const auto views = viewsOfBoard("charuco:7x5:0.054:0.0405:DICT_4X4_50", 1);
  images.insert(images.end(), views.begin(), views.end());
  EXPECT_EQ(bestGuess(images).imageCount, 1);
  EXPECT_EQ(bestGuess(images).searchedImageCount, 7);
}

TEST(BoardGuess, NothingWithoutABoard) {
  cv::Mat noise(480, 640, CV_8UC1);
  cv::RNG(7).fill(noise, cv::RNG::UNIFORM, 0, 255);
  cv::GaussianBlur(noise, noise, {0, 0}, 4.0);
  cv::normalize(noise, noise, 0, 255, cv::NORM_MINMAX);
  cv::Mat windows(480, 640, CV_8UC1, cv::Scalar(200)); // a front of a house is no chessboard
  for (int k = 0; k < 30; ++k) {
    cv::rectangle(windows, {40 + 95 * (k % 6), 30 + 90 * (k / 6), 50, 60}, cv::Scalar(40),
                  cv::FILLED);
  }
  const auto guesses = guessBoards({cv::Mat(480, 640, CV_8UC1, cv::Scalar(128)), noise, windows},
                                   boardOf("chessboard:9x6:0.025"));
  ASSERT_TRUE(guesses);
  EXPECT_TRUE(guesses->empty()) << guessAdviceSentence(guesses->front());
  EXPECT_TRUE(guessBoards({}, boardOf("chessboard:9x6:0.025"))->empty());
}

TEST(BoardGuess, TheSameImagesGiveTheSameBoards) {
  const auto images = viewsOfBoard("charuco:7x5:0.054:0.0405:DICT_4X4_50", 4);
  const auto first = bestGuess(images);
  const auto second = bestGuess(images);
  EXPECT_EQ(first.board, second.board);
  EXPECT_EQ(first.cornerCount, second.cornerCount);
}

TEST(BoardGuess, StopsWhenTold) {
  int calls = 0;
  const auto guesses =
      guessBoards(viewsOfBoard("chessboard:9x6:0.025", 3), boardOf("chessboard:7x5:0.025"),
                  [&](CalibrationStage, double) { return ++calls < 2; });
  ASSERT_FALSE(guesses);
  EXPECT_EQ(guesses.error().code, ErrorCode::Canceled);
  EXPECT_EQ(calls, 2);
}

TEST(BoardGuess, SameBoards) {
  const auto same = [](const char* one, const char* other) {
    return isSameBoard(boardOf(one), boardOf(other));
  };
  EXPECT_TRUE(same("chessboard:9x6:0.025", "chessboard:6x9:0.03"));
  EXPECT_FALSE(same("chessboard:9x6:0.025", "chessboard:9x7:0.025"));
  EXPECT_TRUE(same("charuco:7x5:0.054:0.04:DICT_4X4_50", "charuco:7x5:0.03:0.02:DICT_4X4_1000"));
  EXPECT_FALSE(same("charuco:7x5:0.054:0.04:DICT_4X4_50", "charuco:7x5:0.054:0.04:DICT_5X5_50"));
  EXPECT_FALSE(
      same("charuco:7x5:0.054:0.04:DICT_4X4_50", "charuco:7x5:0.054:0.04:DICT_4X4_50:inverted"));
  EXPECT_FALSE(
      same("charuco:7x6:0.054:0.04:DICT_4X4_50", "charuco:7x6:0.054:0.04:DICT_4X4_50:legacy"));
  EXPECT_FALSE(same("chessboard:7x5:0.054", "charuco:7x5:0.054:0.04:DICT_4X4_50"));
}

TEST(BoardGuess, AProposalIsASentenceWithTheOption) {
  const BoardGuess guess{boardOf("charuco:4x5:0.054:0.0405:DICT_4X4_50:inverted"), false, 12, 5,
                         60};
  EXPECT_EQ(guessAdviceSentence(guess),
            "5 of 12 images searched seem to show a ChArUco board of 4 x 5 squares, DICT_4X4_50, "
            "black and white exchanged: use --board "
            "charuco:4x5:0.054:0.0405:DICT_4X4_50:inverted");
}

} // namespace
} // namespace dewpoint::tests
