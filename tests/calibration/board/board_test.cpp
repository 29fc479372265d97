// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(Board, TextComesBack) {
  for (const char* text : {"chessboard:9x6:0.025", "charuco:7x5:0.054:0.04:DICT_4X4_50",
                           "charuco:5x8:0.03:0.02:DICT_6X6_250:legacy",
                           "charuco:4x5:0.054:0.0405:DICT_4X4_1000:inverted"}) {
    const auto board = parseBoard(text);
    ASSERT_TRUE(board) << errorSentence(board.error());
    EXPECT_EQ(boardText(*board), text);
  }
}

TEST(Board, ErrorsNameThePart) {
  const std::pair<const char*, const char*> cases[] = {
      {"checker:9x6:0.025", "chessboard"},
      {"chessboard:9x6", "SQUARE"},
      {"chessboard:9by6:0.025", "COLUMNSxROWS"},
      {"chessboard:9x6:25", "millimeters"},
      {"chessboard:9x6:-1", "square size"},
      {"chessboard:2x6:0.025", "3 to 200"},
      {"charuco:7x5:0.04:0.054:DICT_4X4_50", "smaller"},
      {"charuco:7x5:0.054:0.04:DICT_4X4_51", "DICT_4X4_50"},
      {"charuco:30x30:0.054:0.04:DICT_4X4_50", "too few markers"},
      {"charuco:7x5:0.054:0.04:DICT_4X4_50:old", "old"},
  };
  for (const auto& [text, expected] : cases) {
    const auto board = parseBoard(text);
    ASSERT_FALSE(board) << text;
    EXPECT_EQ(board.error().field, "--board");
    EXPECT_NE(board.error().detail.find(expected), std::string::npos) << board.error().detail;
  }
}

TEST(Board, SymmetryFollowsFromTheColors) {
  EXPECT_EQ(parseBoard("chessboard:9x6:0.025")->symmetryOrder(), 1);
  EXPECT_EQ(parseBoard("chessboard:7x5:0.025")->symmetryOrder(), 2);
  EXPECT_EQ(parseBoard("chessboard:6x6:0.025")->symmetryOrder(), 4);
  EXPECT_EQ(parseBoard("chessboard:7x7:0.025")->symmetryOrder(), 2);
  EXPECT_EQ(parseBoard("charuco:7x5:0.054:0.04:DICT_4X4_50")->symmetryOrder(), 1);
}

TEST(Board, LegacyMattersForEvenRowsOnly) {
  // OpenCV's manual of CharucoBoard::setLegacyPattern: a white box in the upper left corner if
  // there is an even row count, otherwise a black one.
  EXPECT_TRUE(parseBoard("charuco:5x4:0.054:0.04:DICT_4X4_50")->isBlack(0, 0));
  EXPECT_FALSE(parseBoard("charuco:5x4:0.054:0.04:DICT_4X4_50:legacy")->isBlack(0, 0));
  EXPECT_TRUE(parseBoard("charuco:5x7:0.054:0.04:DICT_4X4_50:legacy")->isBlack(0, 0));
}

} // namespace
} // namespace dewpoint::tests
