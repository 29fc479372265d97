// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Description of a calibration board. The board's coordinate frame is in meters. As seen on the
/// printed page, x points right, y points down, and z points into the page. The origin of a
/// chessboard is its first inner corner. The origin of a ChArUco board is the upper left corner of
/// its first square, as in OpenCV. The first square is the upper left one. It is black, except on a
/// legacy ChArUco board with an even number of rows, where it is white. An inverted board has these
/// colors exchanged.
struct BoardDescription {
  enum class Kind { Chessboard, Charuco };

  Kind kind = Kind::Chessboard;
  int columns = 9; ///< chessboard: inner corners in a row; ChArUco: squares in a row
  int rows = 6;    ///< chessboard: inner corners in a column; ChArUco: squares in a column
  double squareSize = 0.025; ///< side of a square, meters
  double markerSize = 0.0;   ///< side of a marker, meters; ChArUco only
  std::string dictionary;    ///< OpenCV name such as "DICT_4X4_50"; ChArUco only
  /// True if the first square of a ChArUco board is white, as on boards with an even number of rows
  /// that OpenCV before 4.6 created.
  bool usesLegacyLayout = false;
  bool isInverted = false; ///< printed with black and white exchanged

  /// Returns the number of inner corners in a row. Inner corners are those that a BoardDetector
  /// finds.
  int cornerColumns() const { return kind == Kind::Chessboard ? columns : columns - 1; }
  /// Returns the number of inner corners in a column.
  int cornerRows() const { return kind == Kind::Chessboard ? rows : rows - 1; }
  /// Returns the number of inner corners of the whole board.
  int cornerCount() const { return cornerColumns() * cornerRows(); }
  /// Returns the number of squares in a row, for any kind of board.
  int squareColumns() const { return kind == Kind::Chessboard ? columns + 1 : columns; }
  /// Returns the number of squares in a column, for any kind of board.
  int squareRows() const { return kind == Kind::Chessboard ? rows + 1 : rows; }

  /// Returns the position of corner `id` in the board frame, meters. Ids run along the rows,
  /// starting at the upper left.
  Eigen::Vector3d corner(int id) const;
  /// Returns the center of the area covered by all squares, in the board frame; meters.
  Eigen::Vector3d center() const;
  /// Returns whether a square is black on the page, ignoring `isInverted`. On ChArUco boards the
  /// white squares contain the markers.
  bool isBlack(int column, int row) const;
  /// Returns the number of rotations about the board's normal that leave the board unchanged: 1
  /// (unambiguous), 2 or 4.
  int symmetryOrder() const;

  bool operator==(const BoardDescription&) const = default;
};

/// Parses `chessboard:9x6:0.025` (inner corners, square size) or
/// `charuco:7x5:0.054:0.040:DICT_4X4_50[:legacy][:inverted]` (squares, square size, marker size and
/// dictionary). Sizes are in meters. Error: BadValue, which names `field` and the invalid part of
/// the text.
Result<BoardDescription> parseBoard(const std::string& text, const std::string& field = "--board");

/// Checks a board by the rules of parseBoard(). Use it for boards that parseBoard() did not create.
/// Error: BadValue, which names `field` and the invalid part.
Status checkBoard(const BoardDescription& board, const std::string& field = "--board");

/// Returns the text from which parseBoard() recreates the board.
std::string boardText(const BoardDescription& board);

/// Returns the names of the supported marker dictionaries.
const std::vector<std::string>& markerDictionaries();

/// Returns the world-from-board pose of a board that lies on the floor and defines the world. As
/// seen on the printed page, the world's X axis points right, Y points toward the upper edge, and Z
/// points out of the page, which is up in the world.
Eigen::Isometry3d worldFromFlatBoard();

} // namespace dewpoint::calibration
