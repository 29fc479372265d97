// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <utility>
#include <vector>

namespace dewpoint::calibration {

/// Finds the visible corners of a ChArUco board. Writes their numbers to `ids` and their pixel
/// positions to `corners`. `markerSquares`: column and row of the square of each marker.
void findCharucoCorners(const cv::Mat& gray, const BoardDescription& board,
                        const std::vector<std::pair<int, int>>& markerSquares,
                        std::vector<int>& ids, std::vector<cv::Point2f>& corners);

} // namespace dewpoint::calibration
