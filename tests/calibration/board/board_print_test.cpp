// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"
#include "core/calibration/board/board_picture.h"
#include "core/calibration/board/board_print.h"
#include "core/calibration/report/board_report.h"
#include "tests/calibration/board_views.h"

namespace dewpoint::tests {
namespace {

TEST(BoardPrint, WritesAPdfOfOnePage) {
  const auto file = std::filesystem::temp_directory_path() / "dewpoint-board-print-test.pdf";
  for (const char* text : {"chessboard:9x6:0.025", "charuco:7x5:0.025:0.019:DICT_4X4_50",
                           "charuco:5x6:0.03:0.022:DICT_5X5_100:legacy:inverted"}) {
    const auto printed = printBoard(boardOf(text), *paperNamed("a4"), file);
    ASSERT_TRUE(printed) << sentence(printed.error());
    const auto bytes = readTextFile(file);
    ASSERT_TRUE(bytes);
    EXPECT_TRUE(bytes->starts_with("%PDF-"));
    EXPECT_NE(bytes->find("/Count 1"), std::string::npos);
  }
  std::filesystem::remove(file);
}

TEST(BoardPrint, ABoardTooLargeForThePaperIsRefused) {
  const auto printed = printBoard(boardOf("chessboard:9x6:0.05"), *paperNamed("A4"), "none.pdf");
  ASSERT_FALSE(printed);
  EXPECT_EQ(printed.error().field, "paper");
  // 10 x 7 squares within 281 x 178 mm: 25.4 mm by the height
  EXPECT_NE(printed.error().detail.find("0.025 m"), std::string::npos) << printed.error().detail;
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
  report.cameras.push_back(reportPart("left & right", *result));
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
