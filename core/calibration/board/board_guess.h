// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"
#include "core/calibration/bundle/calibration_progress.h"

#include <opencv2/core/mat.hpp>

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Board found in images by guessBoards(), and in how many images and corners it was seen.
struct BoardGuess {
  /// The board that was found. Images do not show the square size, nor whether a chessboard is
  /// `isInverted`; these two are copied from the board that was passed to guessBoards() as
  /// `requested`.
  BoardDescription board;
  /// True if the images are mirrored left to right. A BoardDetector cannot find the board in such
  /// images, whatever the description.
  bool isMirrored = false;
  int searchedImageCount = 0; ///< number of images that were searched
  int imageCount = 0;  ///< number of searched images in which a BoardDetector finds the board
  int cornerCount = 0; ///< total number of corners found in these images
};

/// Returns an image (CV_8UC1 or CV_8UC3, BGR) in the form that guessBoards() uses: gray, and
/// reduced to a width of at most 1280 pixels. To save memory, callers can keep images in this form.
cv::Mat reducedGrayImage(const cv::Mat& image);

/// Returns the boards that are shown in images: chessboards of any size, and ChArUco boards of any
/// size and dictionary with at least four visible markers. Boards may be legacy or inverted, and
/// images may be mirrored. The board with the most corners comes first, because it is the most
/// likely one. Returns an empty list if no board is found. Error: Canceled.
///
/// `images`: CV_8UC1 or CV_8UC3 (BGR), from any cameras. `requested` is the board that the user
/// described. For a ChArUco board, the result names the smallest dictionary that has enough markers
/// with the observed number of cells, unless `requested` names a larger one. The marker size is
/// measured in the images, to a twentieth of a square. Each board is confirmed with a
/// BoardDetector. Deterministic; takes about 0.3 s per image.
Result<std::vector<BoardGuess>> guessBoards(const std::vector<cv::Mat>& images,
                                            const BoardDescription& requested,
                                            const CalibrationProgress& progress = {});

/// Returns whether a BoardDetector finds the same corners with both descriptions. The boards may
/// still differ in their sizes, in the numbers of markers in their dictionaries, and by a half
/// turn.
bool isSameBoard(const BoardDescription& one, const BoardDescription& other);

/// Returns the description of a board in words, for example "ChArUco board of 4 x 5 squares,
/// DICT_4X4_50, black and white exchanged, mirrored".
std::string describeGuess(const BoardGuess& guess);

/// Returns a sentence that tells the user what to do, without a period at its end. Example: "3 of
/// 20 images seem to show another board, a ChArUco board of ...: use --board
/// charuco:4x5:0.054:0.0405:DICT_4X4_50:inverted".
std::string guessAdviceSentence(const BoardGuess& guess);

} // namespace dewpoint::calibration
