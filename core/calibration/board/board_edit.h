// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"

namespace dewpoint::calibration {

// Changes of a board as the user makes them, one quantity at a time. Sizes are counted in squares
// for every kind of board. The result may be impossible; checkBoard() reports that.

/// Board of another kind with the same squares. Markers are three quarters of a square, from
/// DICT_4X4_100, and the board is printed as OpenCV does since 4.6.
BoardDescription withKind(BoardDescription board, BoardDescription::Kind kind);

/// Board with another number of squares in a row and in a column.
BoardDescription withSquares(BoardDescription board, int columns, int rows);

/// Board with squares of another size (meters); markers keep their proportion to the squares. Sizes
/// are rounded to 10 nm to keep rounding errors out of boardText(): 0.01875, not
/// 0.018750000000000003.
BoardDescription withSquareSize(BoardDescription board, double squareSize);

/// Board with markers of another size in meters, rounded likewise.
BoardDescription withMarkerSize(BoardDescription board, double markerSize);

} // namespace dewpoint::calibration
