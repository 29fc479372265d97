// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_detection.h"

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <optional>

namespace dewpoint::calibration {

/// Chessboard-like grid in an image.
struct ChessboardSuggestion {
  cv::Size innerCorners; ///< number of inner corners; width >= height
  /// True if the grid is a complete chessboard (isWholeChessboard()). If false, the grid may be
  /// only part of a board, may continue beyond the detected corners, or may not be a chessboard at
  /// all.
  bool isWhole = false;
};

/// Returns the largest chessboard-like grid in an image (CV_8UC1), or nothing.
std::optional<ChessboardSuggestion> suggestChessboard(const cv::Mat& gray);

/// Returns whether dark and bright squares alternate over the whole detected chessboard, including
/// the squares around its inner corners, and do not continue beyond them. `detection` contains all
/// corners of `board`, in an image (CV_8UC1).
bool isWholeChessboard(const cv::Mat& gray, const BoardDescription& board,
                       const BoardDetection& detection);

} // namespace dewpoint::calibration
