// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"

namespace dewpoint::calibration {

// Edits to a board made by the user, one quantity at a time. Sizes are counted in squares for every
// kind of board. The result may be an impossible board; checkBoard() reports that.

/// Returns a board of another kind with the same squares. Markers are three quarters of a square
/// wide, from DICT_4X4_100, and the board is printed as in OpenCV 4.6 and later.
BoardDescription withKind(BoardDescription board, BoardDescription::Kind kind);

/// Returns the board with another number of squares in a row and in a column.
BoardDescription withSquares(BoardDescription board, int columns, int rows);

/// Returns the board with another square size (meters); markers keep their proportion to the
/// squares. Sizes are rounded to 10 nm to keep rounding errors out of boardText(): 0.01875, not
/// 0.018750000000000003.
BoardDescription withSquareSize(BoardDescription board, double squareSize);

/// Returns the board with another marker size (meters), rounded in the same way.
BoardDescription withMarkerSize(BoardDescription board, double markerSize);

} // namespace dewpoint::calibration
