// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"
#include "core/calibration/board/board_detection.h"

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <vector>

namespace dewpoint::calibration {

/// Refines corners to the saddle point of the gray levels (cv::cornerSubPix) within `halfWindow`
/// pixels of each corner, in each direction. Stops when a corner moves by less than `tolerance`
/// pixels, or after `steps` steps.
void refineCorners(const cv::Mat& gray, int halfWindow, int steps, double tolerance,
                   std::vector<cv::Point2f>& corners);

/// Returns the smallest distance, in pixels, between neighbors in a grid of corners given row by
/// row.
double smallestSpacing(const std::vector<cv::Point2f>& grid, int columns);

/// Returns the median width, in pixels, of the edges between neighboring corners of a detection; 0
/// if nothing could be measured. The width of an edge is the contrast across it divided by its
/// steepest slope. `reach` is the distance from an edge, in squares, up to which the board is plain
/// black on one side and plain white on the other.
double measureEdgeWidth(const cv::Mat& gray, const BoardDescription& board,
                        const BoardDetection& detection, double reach);

/// Returns the interpolated gray level at a point between pixels. For points outside the image,
/// returns the gray level at the nearest point of the image.
double grayAt(const cv::Mat& gray, double column, double row);

} // namespace dewpoint::calibration
