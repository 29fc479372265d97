// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board_edit.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

BoardDescription charuco() {
  return *parseBoard("charuco:8x5:0.04:0.03:DICT_4X4_50");
}

TEST(BoardEdit, TheOtherKindHasTheSameSquares) {
  const auto chess = withKind(charuco(), BoardDescription::Kind::Chessboard);
  EXPECT_EQ(boardText(chess), "chessboard:7x4:0.04");
  EXPECT_EQ(chess.squareColumns(), 8);
  const auto back = withKind(chess, BoardDescription::Kind::Charuco);
  EXPECT_EQ(boardText(back), "charuco:8x5:0.04:0.03:DICT_4X4_100"); // three quarters of 0.04
}

TEST(BoardEdit, SquaresAreCountedAlikeForBothKinds) {
  EXPECT_EQ(withSquares(charuco(), 6, 9).columns, 6);
  const auto chess = withSquares(withKind(charuco(), BoardDescription::Kind::Chessboard), 6, 9);
  EXPECT_EQ(chess.columns, 5);
  EXPECT_EQ(chess.squareRows(), 9);
}

TEST(BoardEdit, MarkersKeepTheirProportionWithoutNoise) {
  // 0.025 * 3/4 is 0.018750000000000003 in binary numbers.
  EXPECT_EQ(boardText(withSquareSize(charuco(), 0.025)), "charuco:8x5:0.025:0.01875:DICT_4X4_50");
  EXPECT_EQ(withSquareSize(charuco(), 1.1 * 0.0254).squareSize, 0.02794); // 1.1 inches
  EXPECT_EQ(withMarkerSize(charuco(), 0.1 * 0.2).markerSize, 0.02);
}

TEST(BoardEdit, AnImpossibleBoardIsSaidInTheWordsOfTheParser) {
  EXPECT_TRUE(checkBoard(charuco()));
  auto wide = charuco();
  wide.columns = 201;
  auto tiny = withKind(charuco(), BoardDescription::Kind::Chessboard);
  tiny.squareSize = 0.0;
  auto large = tiny;
  large.squareSize = 25.0;
  auto few = withSquares(charuco(), 60, 60); // 1800 markers of 50
  for (const auto& board :
       {wide, tiny, large, few, withMarkerSize(charuco(), 0.04), withSquares(charuco(), 2, 3)}) {
    const auto parsed = parseBoard(boardText(board));
    const auto checked = checkBoard(board);
    ASSERT_FALSE(parsed) << boardText(board);
    ASSERT_FALSE(checked) << boardText(board);
    EXPECT_EQ(errorSentence(checked.error()), errorSentence(parsed.error()));
  }
}

} // namespace
} // namespace dewpoint::tests
