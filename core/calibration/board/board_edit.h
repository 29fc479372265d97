// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"

namespace dewpoint::calibration {

// Changes of a board as the user makes them, one quantity at a time: in squares, whatever its kind
// counts. What comes out may still be impossible; checkBoard() says so.

/// The same squares as a board of this kind. Markers are three quarters of a square, of
/// DICT_4X4_100, and the board is printed as OpenCV does since 4.6.
BoardDescription withKind(BoardDescription board, BoardDescription::Kind kind);

/// The number of squares in a row and in a column.
BoardDescription withSquares(BoardDescription board, int columns, int rows);

/// Squares of this size (meters); markers keep their proportion to them. Sizes are rounded to
/// 10 nm, so that units and ratios leave no noise in boardText(): 0.01875, not
/// 0.018750000000000003.
BoardDescription withSquareSize(BoardDescription board, double squareSize);

/// Markers of this size, meters, rounded likewise.
BoardDescription withMarkerSize(BoardDescription board, double markerSize);

} // namespace dewpoint::calibration
