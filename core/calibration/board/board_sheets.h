// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_picture.h"
#include "core/calibration/board/board_print.h"

#include <vector>

namespace dewpoint::calibration {

/// How a board that is larger than the paper is split into parts, one per sheet. All sheets are
/// portrait, or all are landscape. All lengths are in millimeters. Positions on the board are
/// measured from the upper left corner of its whole grid of squares, positions on a page from the
/// upper left corner of the page; y points down.
struct BoardSheets {
  int columns = 1; ///< sheets side by side
  int rows = 1;    ///< sheets below each other
  double pageWidth = 0.0;
  double pageHeight = 0.0;
  double left = 0.0;   ///< of the printed part of each page
  double top = 0.0;    ///< of the printed part of each page
  double width = 0.0;  ///< of the part of the board on each sheet, including the overlap
  double height = 0.0; ///< of the part of the board on each sheet, including the overlap
  double firstX = 0.0; ///< position on the board of the first sheet's part
  double firstY = 0.0; ///< position on the board of the first sheet's part

  int count() const { return columns * rows; }
  /// Returns the position on the board of the part on a sheet.
  double partX(int column) const { return firstX + column * (width - kOverlap); }
  double partY(int row) const { return firstY + row * (height - kOverlap); }

  /// Width of the strip that two neighboring sheets have in common.
  static constexpr double kOverlap = 10.0;
};

/// Splits a board, in the orientation that needs fewer sheets. `border` is the width of what is
/// printed around the squares, millimeters. BadValue if more than kMostSheets sheets were needed.
Result<BoardSheets> splitOnSheets(const BoardDescription& board, const Paper& paper, double border);

/// Largest number of sheets on which a board is printed.
inline constexpr int kMostSheets = 64;

/// Returns the dark rectangles of the part of a board that lies on a sheet, millimeters on the
/// page. `dark`: rectangles on the board, millimeters.
std::vector<BoardPattern::Rectangle>
rectanglesOnSheet(const BoardSheets& sheets, int column, int row,
                  const std::vector<BoardPattern::Rectangle>& dark);

} // namespace dewpoint::calibration
