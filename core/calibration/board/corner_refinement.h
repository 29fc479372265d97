// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"
#include "core/calibration/board/board_detection.h"

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <vector>

namespace dewpoint::calibration {

/// Moves corners onto the saddle point of the gray levels (cv::cornerSubPix) in a window of
/// `halfWindow` pixels around each, until it moves by less than `tolerance`.
void refineCorners(const cv::Mat& gray, int halfWindow, int steps, double tolerance,
                   std::vector<cv::Point2f>& corners);

/// The smallest distance, in pixels, between neighbors of a grid of corners, row by row.
double leastSpacing(const std::vector<cv::Point2f>& grid, int columns);

/// Median width of the edges between neighboring corners of a detection: the contrast across an
/// edge, divided by its steepest slope; pixels. `reach` is how far on both sides of an edge the
/// page is plain, in squares. 0 where nothing could be measured.
double edgeWidth(const cv::Mat& gray, const BoardDescription& board,
                 const BoardDetection& detection, double reach);

/// Gray level at a point between pixels, clamped to the image.
double grayAt(const cv::Mat& gray, double column, double row);

} // namespace dewpoint::calibration
