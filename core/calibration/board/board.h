// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Description of a calibration board. Frame of the board, in meters, as seen on the printed page:
/// x to the right along the columns, y down along the rows, z into the board. Origin: the first
/// inner corner of a chessboard; the upper left corner of the first square of a ChArUco board (as
/// in OpenCV). The first square, upper left, is black (white on a legacy ChArUco board with an even
/// number of rows).
struct BoardDescription {
  enum class Kind { Chessboard, Charuco };

  Kind kind = Kind::Chessboard;
  int columns = 9; ///< chessboard: inner corners in a row; ChArUco: squares in a row
  int rows = 6;    ///< chessboard: inner corners in a column; ChArUco: squares in a column
  double squareSize = 0.025; ///< meters
  double markerSize = 0.0;   ///< meters; ChArUco only
  std::string dictionary;    ///< OpenCV's name, "DICT_4X4_50"; ChArUco only
  bool legacy =
      false; ///< ChArUco with even rows, made by OpenCV before 4.6: the first square is white
  bool inverted = false; ///< printed with black and white exchanged

  /// Number of inner corners, which are what the detector finds: in a row, in a column, in total.
  int cornerColumns() const { return kind == Kind::Chessboard ? columns : columns - 1; }
  int cornerRows() const { return kind == Kind::Chessboard ? rows : rows - 1; }
  int cornerCount() const { return cornerColumns() * cornerRows(); }
  /// Number of squares in a row and in a column.
  int squareColumns() const { return kind == Kind::Chessboard ? columns + 1 : columns; }
  int squareRows() const { return kind == Kind::Chessboard ? rows + 1 : rows; }

  /// Position of corner `id` in the board's frame, meters; ids run along the rows from the upper
  /// left.
  Eigen::Vector3d corner(int id) const;
  /// Center of all squares in the board's frame, meters.
  Eigen::Vector3d center() const;
  /// Returns whether a square is black on the page, ignoring `inverted`. On ChArUco boards the
  /// white squares contain the markers.
  bool isBlack(int column, int row) const;
  /// Number of rotations about its normal that leave the board unchanged: 1 (unambiguous), 2 or 4.
  int symmetry() const;

  bool operator==(const BoardDescription&) const = default;
};

/// Parses `chessboard:9x6:0.025` (inner corners, square size) or
/// `charuco:7x5:0.054:0.040:DICT_4X4_50[:legacy][:inverted]` (squares, square size and marker
/// size); sizes are in meters. BadValue names `field` and the part that is wrong.
Result<BoardDescription> parseBoard(const std::string& text, const std::string& field = "--board");

/// Checks a board that was not made by parseBoard() in the same way. BadValue names `field` and
/// what is wrong, in the same words.
Status checkBoard(const BoardDescription& board, const std::string& field = "--board");

/// Text from which parseBoard() reads the board.
std::string boardText(const BoardDescription& board);

/// Names of the supported marker dictionaries.
const std::vector<std::string>& markerDictionaries();

/// World-from-board pose of a board that lies on the floor and defines the world: X along its
/// columns, Y towards its upper edge, Z up out of the page.
Eigen::Isometry3d worldFromFlatBoard();

} // namespace dewpoint::calibration
