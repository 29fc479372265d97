// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"
#include "core/geometry/camera.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::calibration {

/// What is black and what is white on a board, point by point: for printing, drawing, rendering.
class BoardPattern {
public:
  explicit BoardPattern(const BoardDescription& board);

  const BoardDescription& board() const { return board_; }
  /// A dark rectangle of the page, meters from the upper left corner of the squares, y down.
  struct Rectangle {
    double left, top, width, height;
  };
  /// All dark rectangles; none overlaps another. `inverted` is taken into account within the
  /// squares.
  std::vector<Rectangle> darkRectangles() const;
  /// Whether a point of the board's frame is dark; what is outside the squares is white (black on
  /// an inverted board).
  bool isDark(double x, double y) const;

private:
  /// Whether the cell of a square's marker is dark, `inverted` left aside.
  bool markerCell(int marker, int column, int row) const;
  int markerAt(int column, int row) const;

  BoardDescription board_;
  int cells_ = 0;                          ///< of a marker with its border, in a row
  std::vector<std::vector<char>> markers_; ///< cells row by row, 1: black
  std::vector<int> markerOfSquare_;        ///< -1: none
};

/// The page as a picture, CV_8UC1, with a margin of half a square.
cv::Mat drawBoard(const BoardDescription& board, int pixelsPerSquare);

/// What a camera sees of a board, CV_8UC1: every pixel is the mean of samples x samples rays, so
/// that edges are exact to a part of a pixel. `cameraFromBoard` places the board; the camera's own
/// pose is not used. The ground is mid gray.
cv::Mat renderBoard(const BoardDescription& board, const Camera& camera,
                    const Eigen::Isometry3d& cameraFromBoard, int samples = 6);

} // namespace dewpoint::calibration
