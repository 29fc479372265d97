// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace dewpoint::calibration {

/// Corners of a board detected in one image.
struct BoardDetection {
  std::vector<int> ids; ///< corner numbers, ascending
  /// Corner positions (column, row) in pixels; pixel centers are at integers.
  std::vector<Eigen::Vector2d> pixels;
  /// Median width of the edges between black and white, in pixels: about 1.5 in a sharp image,
  /// larger with defocus or motion blur.
  double edgeWidthPx = 0.0;
};

/// Thoroughness of a search for the board. A more thorough search takes more time.
enum class DetectionEffort {
  Live, ///< searches for the board in a reduced image; for live images
  /// Chessboards: the corners are refined with the settings of OpenCV's calibration sample (11 px
  /// window, 30 steps, 0.1 px tolerance), so that results can be compared with results of that
  /// sample. ChArUco boards: same as Exact.
  Sample,
  Exact ///< tries harder to find the board; takes up to a second per image
};

/// Finds the corners of a board. Chessboards must be completely visible; ChArUco boards may be
/// partly hidden. Corners are numbered from the first square of the board if its colors identify
/// this square. The colors of a symmetric chessboard (BoardDescription::symmetryOrder()) do not
/// identify this square. Its corners are then numbered so that the rows run to the right in the
/// image, as nearly as possible. ChArUco corners are interpolated from the neighboring markers and
/// then refined in the image (Foerstner's method, cv::cornerSubPix).
class BoardDetector {
public:
  explicit BoardDetector(const BoardDescription& board);

  const BoardDescription& board() const { return board_; }
  /// Returns the corners of the board in an image (CV_8UC1 or CV_8UC3, BGR), or nothing if the
  /// board is not found.
  std::optional<BoardDetection> detect(const cv::Mat& image, DetectionEffort effort) const;
  /// Returns the number of corners of a ChArUco board that are found in an image (CV_8UC1 or
  /// CV_8UC3, BGR). Also counts corners that are too few for a detection. Returns 0 for a
  /// chessboard.
  int countCorners(const cv::Mat& image) const;

private:
  BoardDescription board_;
  std::vector<std::pair<int, int>> markerSquares_; ///< column and row of each marker's square
};

/// Returns the median distance, in pixels, between the corners common to two detections; nothing if
/// they have none in common.
std::optional<double> motionBetween(const BoardDetection& one, const BoardDetection& other);

/// Returns the detection of a symmetric chessboard with its corners renumbered, as if the board
/// were rotated by `quarterTurns` quarter turns. This number must be even unless the board is
/// square.
BoardDetection rotated(const BoardDetection& detection, const BoardDescription& board,
                       int quarterTurns);

} // namespace dewpoint::calibration
