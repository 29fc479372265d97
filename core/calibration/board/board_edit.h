// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"

namespace dewpoint::calibration {

// Edits to a board made by the user, one quantity at a time. Sizes are counted in squares for every
// kind of board. The result may be an impossible board; checkBoard() reports that.

/// Returns a board of the kind `kind` with the same squares. The markers of a ChArUco board are
/// from DICT_4X4_100 and three quarters of a square wide. The result is neither `usesLegacyLayout`
/// nor `inverted`.
BoardDescription withKind(BoardDescription board, BoardDescription::Kind kind);

/// Returns the board with `columns` squares in a row and `rows` squares in a column.
BoardDescription withSquares(BoardDescription board, int columns, int rows);

/// Returns the board with another square size (meters); markers keep their proportion to the
/// squares. Sizes are rounded to 10 nm to keep rounding errors out of boardText(): 0.01875, not
/// 0.018750000000000003.
BoardDescription withSquareSize(BoardDescription board, double squareSize);

/// Returns the board with another marker size (meters). The size is rounded to 10 nm, as in
/// withSquareSize().
BoardDescription withMarkerSize(BoardDescription board, double markerSize);

} // namespace dewpoint::calibration
