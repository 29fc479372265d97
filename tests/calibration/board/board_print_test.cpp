// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"
#include "core/calibration/board/board_picture.h"
#include "core/calibration/board/board_print.h"
#include "core/calibration/board/board_sheets.h"
#include "core/calibration/report/board_report.h"
#include "tests/calibration/board_views.h"

#include <algorithm>

namespace dewpoint::tests {
namespace {

TEST(BoardPrint, WritesAPdfOfOnePage) {
  const auto file = std::filesystem::temp_directory_path() / "dewpoint-board-print-test.pdf";
  for (const char* text : {"chessboard:9x6:0.025", "charuco:7x5:0.025:0.019:DICT_4X4_50",
                           "charuco:5x6:0.03:0.022:DICT_5X5_100:legacy:inverted"}) {
    const auto printed = printBoard(boardOf(text), *paperNamed("a4"), file);
    ASSERT_TRUE(printed) << errorSentence(printed.error());
    const auto bytes = readTextFile(file);
    ASSERT_TRUE(bytes);
    EXPECT_TRUE(bytes->starts_with("%PDF-"));
    EXPECT_NE(bytes->find("/Count 1"), std::string::npos);
  }
  std::filesystem::remove(file);
}

TEST(BoardPrint, ABoardLargerThanThePaperIsSplitOnSheets) {
  const auto file = std::filesystem::temp_directory_path() / "dewpoint-board-sheets-test.pdf";
  for (const char* text : {"chessboard:9x6:0.05", "charuco:7x5:0.1:0.075:DICT_4X4_50:inverted"}) {
    for (const Paper& paper : papers()) {
      const auto sheets = countSheetsToPrint(boardOf(text), paper);
      ASSERT_TRUE(sheets) << errorSentence(sheets.error());
      EXPECT_GT(*sheets, 1) << text << " " << paper.name;
      ASSERT_TRUE(printBoard(boardOf(text), paper, file));
      const auto bytes = readTextFile(file);
      ASSERT_TRUE(bytes);
      // A plan, and the sheets.
      EXPECT_NE(bytes->find("/Count " + std::to_string(*sheets + 1)), std::string::npos) << text;
    }
  }
  std::filesystem::remove(file);
  EXPECT_EQ(countSheetsToPrint(boardOf("chessboard:9x6:0.025"), *paperNamed("A4")).value(), 1);
  // 500 x 350 mm on parts of 184 x 255 mm that overlap by 10 mm: 3 x 2; lengthwise 271 x 168: 2
  // x 3.
  EXPECT_EQ(countSheetsToPrint(boardOf("chessboard:9x6:0.05"), *paperNamed("A4")).value(), 6);
  EXPECT_EQ(countSheetsToPrint(boardOf("chessboard:9x6:0.05"), *paperNamed("A3")).value(), 2);
}

TEST(BoardPrint, TheSheetsTogetherAreTheBoard) {
  const BoardDescription board = boardOf("charuco:7x5:0.1:0.075:DICT_4X4_50");
  std::vector<BoardPattern::Rectangle> dark;
  for (const auto& one : BoardPattern(board).darkRectangles()) {
    dark.push_back({1000.0 * one.left, 1000.0 * one.top, 1000.0 * one.width, 1000.0 * one.height});
  }
  const auto sheets = splitOnSheets(board, *paperNamed("letter"), 0.0);
  ASSERT_TRUE(sheets);
  // Everything is on a sheet, and neighbors have a strip of 10 mm in common.
  EXPECT_LE(sheets->partLeft(0), 0.0);
  EXPECT_LE(sheets->partTop(0), 0.0);
  EXPECT_GE(sheets->partLeft(sheets->columnCount - 1) + sheets->partWidth, 700.0);
  EXPECT_GE(sheets->partTop(sheets->rowCount - 1) + sheets->partHeight, 500.0);
  EXPECT_DOUBLE_EQ(sheets->partLeft(0) + sheets->partWidth - sheets->partLeft(1),
                   BoardSheets::kOverlapMm);
  const auto isDark = [](const std::vector<BoardPattern::Rectangle>& all, double x, double y) {
    return std::ranges::any_of(all, [&](const auto& one) {
      return x >= one.left && x < one.left + one.width && y >= one.top && y < one.top + one.height;
    });
  };
  for (int row = 0; row < sheets->rowCount; ++row) {
    for (int column = 0; column < sheets->columnCount; ++column) {
      const auto parts = rectanglesOnSheet(*sheets, column, row, dark);
      for (int k = 0; k < 200; ++k) {
        const double x = sheets->partWidth * (k % 17 + 0.37) / 17.0;
        const double y = sheets->partHeight * (k / 17 + 0.41) / 12.0; // NOLINT: whole rows
        ASSERT_EQ(isDark(parts, sheets->printedLeft + x, sheets->printedTop + y),
                  isDark(dark, sheets->partLeft(column) + x, sheets->partTop(row) + y))
            << column << " " << row << " " << k;
      }
      for (const auto& part : parts) { // nothing on the edge of the page, where the marks are
        EXPECT_GE(part.left, sheets->printedLeft - 1e-9);
        EXPECT_LE(part.left + part.width, sheets->printedLeft + sheets->partWidth + 1e-9);
        EXPECT_LE(part.top + part.height, sheets->printedTop + sheets->partHeight + 1e-9);
      }
    }
  }
}

TEST(BoardPrint, ABoardOfTooManySheetsIsRefused) {
  const auto printed = printBoard(boardOf("chessboard:9x6:0.9"), *paperNamed("A4"), "none.pdf");
  ASSERT_FALSE(printed);
  EXPECT_EQ(printed.error().field, "paper");
  EXPECT_NE(printed.error().detail.find("more than 64 sheets"), std::string::npos)
      << printed.error().detail;
  EXPECT_FALSE(std::filesystem::exists("none.pdf"));
  EXPECT_FALSE(paperNamed("B5"));
}

TEST(BoardPrint, DarkRectanglesAreWhatIsDark) {
  for (const char* text : {"chessboard:4x3:0.02", "charuco:4x4:0.02:0.015:DICT_4X4_50:legacy",
                           "charuco:4x3:0.02:0.015:DICT_4X4_50:inverted"}) {
    const BoardDescription board = boardOf(text);
    const BoardPattern pattern(board);
    const double offset = board.kind == BoardDescription::Kind::Chessboard ? board.squareSize : 0.0;
    for (int k = 0; k < 4000; ++k) {
      const double x = board.squareSize * board.squareColumns() * (k % 63 + 0.37) / 63.0;
      const double y = board.squareSize * board.squareRows() * (k / 63 + 0.41) / 64.0; // NOLINT
      int covered = 0;
      for (const auto& dark : pattern.darkRectangles()) {
        covered += x >= dark.left && x < dark.left + dark.width && y >= dark.top &&
                           y < dark.top + dark.height
                       ? 1
                       : 0;
      }
      ASSERT_EQ(covered, pattern.isDark(x - offset, y - offset) ? 1 : 0)
          << text << " " << x << " " << y;
    }
  }
}

TEST(BoardReport, IsOnePageWithEverythingInIt) {
  IntrinsicsRequest request{boardOf("chessboard:9x6:0.025"), {}, 640, 480};
  for (const auto& pose : variedPoses(request.board, testCamera(), 8, 9)) {
    request.views.push_back(viewOf(request.board, testCamera(), pose, 0.1,
                                   static_cast<std::uint32_t>(request.views.size())));
  }
  const auto result = calibrateIntrinsics(request);
  ASSERT_TRUE(result);
  BoardReport report;
  report.title = "Lens <1>";
  report.board = request.board;
  report.cameras.push_back(reportPartOf("left & right", *result));
  report.boardPoses.push_back({0, worldFromFlatBoard()});
  const std::string html = htmlText(report);
  for (const char* part : {"Lens &lt;1&gt;", "left &amp; right", "chessboard:9x6:0.025", "<svg",
                           "view 3", "standard deviation", "In space"}) {
    EXPECT_NE(html.find(part), std::string::npos) << part;
  }
  for (const char* outside : {"http", "src=", "<script"}) {
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  }
}

} // namespace
} // namespace dewpoint::tests
