// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"
#include "core/geometry/camera.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::calibration {

/// Black-and-white pattern of a board, for printing, drawing and rendering.
class BoardPattern {
public:
  explicit BoardPattern(const BoardDescription& board);

  const BoardDescription& board() const { return board_; }
  /// Dark rectangle on the page, in meters from the upper left corner of the squares, y down.
  struct Rectangle {
    double left, top, width, height;
  };
  /// Returns all dark rectangles, which do not overlap. On an inverted board, these are the squares
  /// and marker cells that are dark after black and white are exchanged; the page around the
  /// squares is not included.
  std::vector<Rectangle> darkRectangles() const;
  /// Returns whether a point in the board frame (meters) is dark. Everything outside the squares is
  /// white (black on an inverted board).
  bool isDark(double x, double y) const;

private:
  /// Returns whether a cell of a marker is dark, ignoring `inverted`.
  bool isMarkerCellDark(int marker, int column, int row) const;
  int markerAt(int column, int row) const;

  BoardDescription board_;
  int cells_ = 0; ///< number of cells in a row of a marker, including its border
  std::vector<std::vector<char>> markers_; ///< cells of each marker, row by row; 1: black
  std::vector<int> markerOfSquare_;        ///< index of the marker in each square; -1: no marker
};

/// Returns an image of the board as printed, CV_8UC1, with a margin of half a square.
cv::Mat drawBoard(const BoardDescription& board, int pixelsPerSquare);

/// Renders a board as seen by a camera, CV_8UC1. Each pixel is the mean of samples x samples rays,
/// so that edges are accurate to a fraction of a pixel. `cameraFromBoard` is the pose of the board;
/// the camera's own pose is not used. The background is mid-gray.
cv::Mat renderBoard(const BoardDescription& board, const Camera& camera,
                    const Eigen::Isometry3d& cameraFromBoard, int samples = 6);

} // namespace dewpoint::calibration
