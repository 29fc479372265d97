// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_detection.h"

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <optional>

namespace dewpoint::calibration {

/// Chessboard-like grid in an image.
struct ChessboardSuggestion {
  cv::Size size; ///< number of inner corners; width >= height
  /// isWholeChessboard(). If false, the grid may be a part of a board, continue beside it, or be
  /// something else.
  bool whole = false;
};

/// Returns the largest chessboard-like grid in an image (CV_8UC1), or nothing.
std::optional<ChessboardSuggestion> suggestChessboard(const cv::Mat& gray);

/// Returns whether dark and bright squares alternate over the whole detected chessboard, including
/// the squares around its inner corners, and do not go on beyond them. `detection`: all corners of
/// `board`, in an image (CV_8UC1).
bool isWholeChessboard(const cv::Mat& gray, const BoardDescription& board,
                       const BoardDetection& detection);

} // namespace dewpoint::calibration
