// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_detection.h"

#include <opencv2/core/types.hpp>

#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// Finds all corners of a chessboard in a gray image (CV_8UC1), in the order of their numbers.
/// Returns nothing if the board is not completely visible.
std::optional<std::vector<cv::Point2f>>
chessboardCorners(const cv::Mat& gray, const BoardDescription& board, DetectionEffort effort);

/// Returns how the corners of a grid are renumbered if the grid is rotated by quarter turns: the
/// old number of each corner, in the order of the new numbers. `columns` is the number of columns
/// before the rotation.
std::vector<std::size_t> rotatedOrder(std::size_t cornerCount, int columns, int quarterTurns);

} // namespace dewpoint::calibration
