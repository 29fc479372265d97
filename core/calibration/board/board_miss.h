// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_detection.h"

#include <opencv2/core/mat.hpp>

#include <string>

namespace dewpoint::calibration {

/// Reason why a board was not found in an image.
struct BoardMiss {
  enum class Reason {
    Unknown,       ///< the image may not show the board at all
    TooFewCorners, ///< the image shows only a part of the board
    Blurred,       ///< no vertical edge in the image is sharp, or no horizontal one
    TooSmall,      ///< the board is found after the image is enlarged
  };
  Reason reason = Reason::Unknown;
  int cornerCount = 0;       ///< TooFewCorners: number of corners that were found
  double edgeWidthPx = 0.0;  ///< Blurred: width of the sharpest edges in the image, pixels
  double squareSizePx = 0.0; ///< TooSmall: side of the squares in the image, pixels

  bool operator==(const BoardMiss&) const = default;
};

/// Returns the reason why `detector` does not find its board in an image (CV_8UC1 or CV_8UC3, BGR).
/// Returns Unknown unless the image proves a reason: the board is found in the reduced or enlarged
/// image, or a part of the board is found in the original image. Takes up to a few seconds.
BoardMiss diagnoseMissedBoard(const BoardDetector& detector, const cv::Mat& image);

/// Returns the reason in a few words: "blurred, edges of 9 px". Empty if it is not known.
std::string missReasonText(const BoardMiss& miss);

} // namespace dewpoint::calibration
