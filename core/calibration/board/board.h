// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// A calibration board. Its frame: x to the right along the columns, y down along the rows, z into
/// the board, as a person sees the printed page; meters. Origin: the first inner corner of a
/// chessboard, the upper left corner of the first square of a ChArUco board (as OpenCV counts).
/// The first square, upper left, is black (white on a legacy ChArUco board with even rows).
struct BoardDescription {
  enum class Kind { Chessboard, Charuco };

  Kind kind = Kind::Chessboard;
  int columns = 9;           ///< chessboard: inner corners in a row; ChArUco: squares in a row
  int rows = 6;              ///< likewise, in a column
  double squareSize = 0.025; ///< meters
  double markerSize = 0.0;   ///< meters; ChArUco only
  std::string dictionary;    ///< OpenCV's name, "DICT_4X4_50"; ChArUco only
  bool legacy = false;       ///< ChArUco with even rows from OpenCV before 4.6: first square white
  bool inverted = false;     ///< printed with black and white exchanged

  /// The number of inner corners, which are what is detected: in a row, in a column, in all.
  int cornerColumns() const { return kind == Kind::Chessboard ? columns : columns - 1; }
  int cornerRows() const { return kind == Kind::Chessboard ? rows : rows - 1; }
  int cornerCount() const { return cornerColumns() * cornerRows(); }
  /// Squares in a row and in a column.
  int squareColumns() const { return kind == Kind::Chessboard ? columns + 1 : columns; }
  int squareRows() const { return kind == Kind::Chessboard ? rows + 1 : rows; }

  /// Where corner `id` lies, in the board's frame; ids run along the rows from the upper left.
  Eigen::Vector3d corner(int id) const;
  /// The center of all squares, in the board's frame.
  Eigen::Vector3d center() const;
  /// Whether a square is black on the page, `inverted` left aside. On ChArUco boards the white
  /// squares carry the markers.
  bool isBlack(int column, int row) const;
  /// How many turns about its normal leave the board as it was: 1 (it is told apart), 2 or 4.
  int symmetry() const;

  bool operator==(const BoardDescription&) const = default;
};

/// Reads `chessboard:9x6:0.025` (inner corners, square size) or
/// `charuco:7x5:0.054:0.040:DICT_4X4_50[:legacy][:inverted]` (squares, square and marker size);
/// meters. BadValue names `field` and the part that is wrong.
Result<BoardDescription> parseBoard(const std::string& text, const std::string& field = "--board");

/// Whether a board that was put together otherwise is one that parseBoard() would give. BadValue
/// names `field` and what is wrong, in the same words.
Status checkBoard(const BoardDescription& board, const std::string& field = "--board");

/// The text parseBoard() reads.
std::string boardText(const BoardDescription& board);

/// Names of the marker dictionaries that are known.
const std::vector<std::string>& markerDictionaries();

/// World from board, where a board that lies on the floor makes the world: X along its columns, Y
/// towards its upper edge, Z up out of the page.
Eigen::Isometry3d worldFromFlatBoard();

} // namespace dewpoint::calibration
