// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board_sheets.h"

#include "core/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace dewpoint::calibration {
namespace {

/// White edge of a page, which printers leave white (8 mm), and the marks for the cuts beside it.
constexpr double kSheetEdge = 13.0;
constexpr double kSheetFoot = 16.0; ///< for the scale bar and the text

int sheetsFor(double length, double part) {
  return std::max(1, static_cast<int>(std::ceil((length - BoardSheets::kOverlapMm) /
                                                (part - BoardSheets::kOverlapMm))));
}

BoardSheets splitIn(double boardWidth, double boardHeight, double border, double pageWidth,
                    double pageHeight) {
  BoardSheets sheets;
  sheets.pageWidth = pageWidth;
  sheets.pageHeight = pageHeight;
  sheets.printedLeft = kSheetEdge;
  sheets.printedTop = kSheetEdge;
  sheets.partWidth = pageWidth - 2.0 * kSheetEdge;
  sheets.partHeight = pageHeight - 2.0 * kSheetEdge - kSheetFoot;
  const double width = boardWidth + 2.0 * border;
  const double height = boardHeight + 2.0 * border;
  sheets.columnCount = sheetsFor(width, sheets.partWidth);
  sheets.rowCount = sheetsFor(height, sheets.partHeight);
  // What is left over is shared by both ends.
  const double covered =
      sheets.columnCount * (sheets.partWidth - BoardSheets::kOverlapMm) + BoardSheets::kOverlapMm;
  const double coveredDown =
      sheets.rowCount * (sheets.partHeight - BoardSheets::kOverlapMm) + BoardSheets::kOverlapMm;
  sheets.firstPartLeft = 0.5 * (boardWidth - covered);
  sheets.firstPartTop = 0.5 * (boardHeight - coveredDown);
  return sheets;
}

} // namespace

Result<BoardSheets> splitOnSheets(const BoardDescription& board, const Paper& paper,
                                  double border) {
  const double width = inMillimeters(board.squareSize) * board.squareColumns();
  const double height = inMillimeters(board.squareSize) * board.squareRows();
  // Before anything is counted in whole numbers: a board in millimeters has millions of sheets.
  const double area = (width / paper.width) * (height / paper.height);
  std::optional<BoardSheets> best;
  if (area <= kMaxSheets) {
    for (const bool lengthwise : {false, true}) {
      const BoardSheets sheets =
          splitIn(width, height, border, lengthwise ? paper.height : paper.width,
                  lengthwise ? paper.width : paper.height);
      if (sheets.sheetCount() <= kMaxSheets &&
          (!best || sheets.sheetCount() < best->sheetCount())) {
        best = sheets;
      }
    }
  }
  if (!best) {
    return failure(ErrorCode::BadValue, "", "paper",
                   fmt::format("the board of {:.0f} x {:.0f} mm needs more than {} sheets of {}",
                               width, height, kMaxSheets, paper.name));
  }
  return *best;
}

std::vector<BoardPattern::Rectangle>
rectanglesOnSheet(const BoardSheets& sheets, int column, int row,
                  const std::vector<BoardPattern::Rectangle>& dark) {
  const double x = sheets.partLeft(column);
  const double y = sheets.partTop(row);
  std::vector<BoardPattern::Rectangle> parts;
  for (const auto& rectangle : dark) {
    const double left = std::max(rectangle.left, x);
    const double top = std::max(rectangle.top, y);
    const double right = std::min(rectangle.left + rectangle.width, x + sheets.partWidth);
    const double bottom = std::min(rectangle.top + rectangle.height, y + sheets.partHeight);
    if (left < right && top < bottom) {
      parts.push_back(
          {sheets.printedLeft + left - x, sheets.printedTop + top - y, right - left, bottom - top});
    }
  }
  return parts;
}

} // namespace dewpoint::calibration
