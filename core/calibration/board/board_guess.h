// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"
#include "core/calibration/bundle/calibration_progress.h"

#include <opencv2/core/mat.hpp>

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Board that a few images show, found without knowing what to look for.
struct BoardGuess {
  /// The board. Its square size and, on a chessboard, `inverted` cannot be seen and are those of
  /// the requested board.
  BoardDescription board;
  bool mirrored = false; ///< the images are mirrored left to right: no description helps
  int searched = 0;      ///< number of images that were searched
  int images = 0;        ///< number of them in which a BoardDetector finds the board
  int corners = 0;       ///< number of corners that it finds in them
};

/// Returns an image (CV_8UC1 or CV_8UC3, BGR) as guessBoards() uses it: gray, and reduced to a
/// width of at most 1280 pixels. Images that are kept for it take less memory so.
cv::Mat imageForGuess(const cv::Mat& image);

/// Finds out which boards images show: chessboards of any size, and ChArUco boards of any size and
/// dictionary, with at least four visible markers, also legacy, inverted, or in mirrored images.
/// `images`: CV_8UC1 or CV_8UC3 (BGR), of any cameras. Each board is confirmed with a
/// BoardDetector. The most likely board comes first: the one with the most corners. A dictionary is
/// the smallest one of its kind that has enough markers, unless `requested` names a larger one. The
/// marker size follows from the images, to a twentieth of a square. Deterministic; takes about 0.3
/// s an image. Returns an empty list if there is no board, or Canceled.
Result<std::vector<BoardGuess>> guessBoards(const std::vector<cv::Mat>& images,
                                            const BoardDescription& requested,
                                            const CalibrationProgress& progress = {});

/// Returns whether a BoardDetector finds the same corners with both descriptions. Sizes, the
/// numbers of markers in the dictionaries and half turns do not matter.
bool isSameBoard(const BoardDescription& one, const BoardDescription& other);

/// Returns the description in words: "ChArUco board of 4 x 5 squares, DICT_4X4_50, black and white
/// exchanged, mirrored".
std::string guessText(const BoardGuess& guess);

/// Returns a sentence with what to do: "3 of 20 images seem to show another board, a ChArUco board
/// of ...: use --board charuco:4x5:0.054:0.0405:DICT_4X4_50:inverted". Without a period.
std::string proposalText(const BoardGuess& guess);

} // namespace dewpoint::calibration
