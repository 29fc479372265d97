// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_picture.h"
#include "core/calibration/board/board_print.h"

#include <vector>

namespace dewpoint::calibration {

/// Division of a board that is larger than the paper into parts, one per sheet. All sheets are
/// portrait, or all are landscape. All lengths are in millimeters. Positions on the board are
/// measured from the upper left corner of its grid of squares. Positions on a page are measured
/// from the upper left corner of the page. In both cases, y points down.
struct BoardSheets {
  int columnCount = 1; ///< sheets side by side
  int rowCount = 1;    ///< sheets below each other
  double pageWidth = 0.0;
  double pageHeight = 0.0;
  double printedLeft = 0.0; ///< left edge of the printed area, on each page
  double printedTop = 0.0;  ///< upper edge of the printed area, on each page
  double partWidth = 0.0;   ///< width of the part of the board on each sheet, including the overlap
  double partHeight = 0.0; ///< height of the part of the board on each sheet, including the overlap
  double firstPartLeft = 0.0; ///< left edge, on the board, of the part on the first sheet
  double firstPartTop = 0.0;  ///< upper edge, on the board, of the part on the first sheet

  int sheetCount() const { return columnCount * rowCount; }
  /// Returns the left edge, on the board, of the parts on the sheets in a column (from 0).
  double partLeft(int column) const { return firstPartLeft + column * (partWidth - kOverlapMm); }
  /// Returns the upper edge, on the board, of the parts on the sheets in a row (from 0).
  double partTop(int row) const { return firstPartTop + row * (partHeight - kOverlapMm); }

  /// Width of the strip of the board that is printed on both of two neighboring sheets.
  static constexpr double kOverlapMm = 10.0;
};

/// Splits a board into parts that fit on sheets of `paper`. Chooses portrait or landscape,
/// whichever needs fewer sheets. `border` is the width of the printed strip around the squares,
/// millimeters. Error: BadValue if more than kMaxSheets sheets would be needed.
Result<BoardSheets> splitOnSheets(const BoardDescription& board, const Paper& paper, double border);

/// Largest number of sheets on which a board is printed.
inline constexpr int kMaxSheets = 64;

/// Returns the dark rectangles of the part of a board that is printed on one sheet, in positions on
/// the page; millimeters. `dark` contains all dark rectangles, in positions on the board;
/// millimeters.
std::vector<BoardPattern::Rectangle>
rectanglesOnSheet(const BoardSheets& sheets, int column, int row,
                  const std::vector<BoardPattern::Rectangle>& dark);

} // namespace dewpoint::calibration
