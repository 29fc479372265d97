// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board_edit.h"

#include <cmath>
#include <utility>

namespace dewpoint::calibration {
namespace {

constexpr double kMarkerFraction = 0.75; ///< of a square, where it is not known yet

double rounded(double meters) {
  constexpr double kPerMeter = 1e8;
  return std::round(meters * kPerMeter) / kPerMeter;
}

} // namespace

BoardDescription withKind(BoardDescription board, BoardDescription::Kind kind) {
  const int columns = board.squareColumns();
  const int rows = board.squareRows();
  board.kind = kind;
  board = withSquares(std::move(board), columns, rows);
  const bool markers = kind == BoardDescription::Kind::Charuco;
  board.markerSize = markers ? rounded(kMarkerFraction * board.squareSize) : 0.0;
  board.dictionary = markers ? "DICT_4X4_100" : "";
  board.usesLegacyLayout = false;
  board.isInverted = false;
  return board;
}

BoardDescription withSquares(BoardDescription board, int columns, int rows) {
  const int uncounted = board.kind == BoardDescription::Kind::Chessboard ? 1 : 0;
  board.columns = columns - uncounted;
  board.rows = rows - uncounted;
  return board;
}

BoardDescription withSquareSize(BoardDescription board, double squareSize) {
  const double size = rounded(squareSize);
  board.markerSize = rounded(board.markerSize * size / board.squareSize);
  board.squareSize = size;
  return board;
}

BoardDescription withMarkerSize(BoardDescription board, double markerSize) {
  board.markerSize = rounded(markerSize);
  return board;
}

} // namespace dewpoint::calibration
