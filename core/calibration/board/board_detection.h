// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace dewpoint::calibration {

/// The corners of a board in one image.
struct BoardDetection {
  std::vector<int> ids;                ///< which corners, rising
  std::vector<Eigen::Vector2d> pixels; ///< where: column, row; pixel centers are whole numbers
  /// Median width of the edges between black and white, in pixels: about 1.5 when sharp, more when
  /// out of focus or moving.
  double edgeWidthPx = 0.0;
};

/// How much time a detection may take.
enum class DetectionEffort {
  Live,   ///< searches for the board in a smaller picture; for pictures that follow one another
  Sample, ///< chessboards as OpenCV's own calibration sample does (11 px, 30 steps, 0.1 px), so
          ///< that figures compare; ChArUco boards as Exact
  Exact   ///< tries harder to find the board; up to a second per picture
};

/// Finds the corners of a board. Chessboards are found whole or not at all, ChArUco boards also in
/// part. Corners are counted from the first square wherever the colors tell it; where a chessboard
/// is symmetric(), rows run to the right in the image as far as possible.
/// ChArUco corners are interpolated from the markers beside them and then refined on the image
/// (Foerstner's method, cv::cornerSubPix): Debian's OpenCV 4.6 shifts its own by half a pixel.
class BoardDetector {
public:
  explicit BoardDetector(const BoardDescription& board);

  const BoardDescription& board() const { return board_; }
  /// Nothing when the board is not there. `image`: CV_8UC1 or CV_8UC3 (BGR).
  std::optional<BoardDetection> detect(const cv::Mat& image, DetectionEffort effort) const;

private:
  BoardDescription board_;
  std::vector<std::pair<int, int>> markerSquares_; ///< column and row of each marker's square
};

/// Median distance, in pixels, between the corners two detections share; nothing when they share
/// none.
std::optional<double> motionBetween(const BoardDetection& one, const BoardDetection& other);

/// The corners of a symmetric chessboard counted after `quarterTurns` quarter turns (those of half
/// a turn only, unless it is square).
BoardDetection rotated(const BoardDetection& detection, const BoardDescription& board,
                       int quarterTurns);

} // namespace dewpoint::calibration
