// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"
#include "core/calibration/board/board_detection.h"

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <vector>

namespace dewpoint::calibration {

/// Refines corners to the saddle point of the gray levels (cv::cornerSubPix) in a window of
/// `halfWindow` pixels around each, until a corner moves by less than `tolerance` pixels, in at
/// most `steps` steps.
void refineCorners(const cv::Mat& gray, int halfWindow, int steps, double tolerance,
                   std::vector<cv::Point2f>& corners);

/// Smallest distance, in pixels, between neighbors in a grid of corners given row by row.
double leastSpacing(const std::vector<cv::Point2f>& grid, int columns);

/// Median width in pixels of the edges between neighboring corners of a detection: the contrast
/// across an edge divided by its steepest slope. `reach` is the distance from an edge to both sides
/// within which the page is plain, in squares. 0 if nothing could be measured.
double edgeWidth(const cv::Mat& gray, const BoardDescription& board,
                 const BoardDetection& detection, double reach);

/// Interpolated gray level at a point between pixels, clamped to the image.
double grayAt(const cv::Mat& gray, double column, double row);

} // namespace dewpoint::calibration
