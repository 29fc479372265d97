// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board_guess.h"

#include "core/calibration/board/board_detection.h"
#include "core/calibration/board/board_edit.h"
#include "core/calibration/board/chessboard_size.h"
#include "core/calibration/board/marker_grid.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr int kGuessWidth = 1280;         ///< pixels; wider images are reduced
constexpr std::size_t kMostSizes = 4;     ///< sizes of chessboards to confirm
constexpr double kSameMarkerPart = 0.06;  ///< the requested marker size is kept within
constexpr double kMarkerPartSteps = 20.0; ///< per square, to which a measured one is rounded
constexpr int kSurelyChessboard = 20;     ///< corners: fewer must be seen in two images
constexpr double kReadingShare = 0.5;     ///< of the time; the rest confirms
constexpr int kChessboardConfirmingImages = 2;

constexpr int kMostFailures = 2; ///< to find a size with the most effort: up to a second each
/// Enough images with so many markers of one kind: the others need not be read.
constexpr int kEnoughReadImages = 6;
constexpr std::size_t kManyMarkers = 5;

using KindOfBoard = BoardDescription::Kind;

/// Number of the code in markerCodes() to which a dictionary belongs.
int codeOf(const std::string& dictionary) {
  const auto& codes = markerCodes();
  const auto stem = [](const std::string& name) { return name.substr(0, name.rfind('_')); };
  const auto found = std::ranges::find_if(
      codes, [&](const std::string& code) { return stem(code) == stem(dictionary); });
  return static_cast<int>(found - codes.begin());
}

/// The board with the smallest dictionary that has all its markers, or the requested larger one.
std::optional<BoardDescription> withDictionary(BoardDescription board, int code,
                                               const BoardDescription& requested) {
  if (requested.kind == KindOfBoard::Charuco && codeOf(requested.dictionary) == code) {
    board.dictionary = requested.dictionary;
    if (checkBoard(board)) {
      return board;
    }
  }
  for (const std::string& name : markerDictionaries()) {
    board.dictionary = name;
    if (codeOf(name) == code && checkBoard(board)) {
      return board;
    }
  }
  return std::nullopt;
}

std::optional<BoardDescription> boardOfGrid(const MarkerGrid& grid, const MarkerReading& reading,
                                            const BoardDescription& requested) {
  BoardDescription board;
  board.kind = KindOfBoard::Charuco;
  board.columns = grid.columns;
  board.rows = grid.rows;
  board.squareSize = requested.squareSize;
  board.usesLegacyLayout = grid.isFirstSquareWhite;
  board.isInverted = reading.isInverted;
  const double part =
      requested.kind == KindOfBoard::Charuco ? requested.markerSize / requested.squareSize : 0.0;
  board = std::abs(part - grid.markerToSquareRatio) < kSameMarkerPart
              ? withMarkerSize(board, requested.markerSize)
              : withMarkerSize(board, board.squareSize *
                                          std::round(grid.markerToSquareRatio * kMarkerPartSteps) /
                                          kMarkerPartSteps);
  return withDictionary(board, reading.codeIndex, requested);
}

/// Counts the images in which the board is found.
BoardGuess confirmedGuess(const BoardDescription& board, bool mirrored,
                          const std::vector<cv::Mat>& images) {
  BoardGuess guess{board, mirrored, static_cast<int>(images.size()), 0, 0};
  const BoardDetector detector(board);
  for (const cv::Mat& gray : images) {
    cv::Mat seen;
    if (mirrored) {
      cv::flip(gray, seen, 1); // into memory of its own: the images are those of the caller
    } else {
      seen = gray;
    }
    if (const auto found = detector.detect(seen, DetectionEffort::Exact)) {
      ++guess.imageCount;
      guess.cornerCount += static_cast<int>(found->ids.size());
    }
  }
  return guess;
}

/// The ChArUco boards, or nothing when canceled.
std::optional<std::vector<BoardGuess>> charucoGuesses(const std::vector<cv::Mat>& images,
                                                      const BoardDescription& requested,
                                                      const CalibrationProgress& progress) {
  std::map<MarkerReading, std::vector<std::vector<ReadMarker>>> readings;
  for (std::size_t k = 0; k < images.size(); ++k) {
    if (!reportProgress(progress, CalibrationStage::BoardDetection,
                        kReadingShare * static_cast<double>(k) /
                            static_cast<double>(images.size()))) {
      return std::nullopt;
    }
    int enough = 0;
    for (auto& [reading, markers] : readMarkersInAnyCode(images[k])) {
      auto& all = readings[reading];
      all.push_back(std::move(markers));
      const auto full =
          std::ranges::count_if(all, [](const auto& read) { return read.size() >= kManyMarkers; });
      enough = std::max(enough, static_cast<int>(full));
    }
    if (enough >= kEnoughReadImages) {
      break;
    }
  }
  std::vector<BoardGuess> guesses;
  for (const auto& [reading, markers] : readings) {
    for (const MarkerGrid& grid : findMarkerGrids(markers)) {
      if (!reportProgress(progress, CalibrationStage::BoardDetection, kReadingShare)) {
        return std::nullopt;
      }
      if (const auto board = boardOfGrid(grid, reading, requested)) {
        guesses.push_back(confirmedGuess(*board, reading.isMirrored, images));
      }
    }
  }
  return guesses;
}

bool showsChessboard(const cv::Mat& gray, const BoardDetector& detector, DetectionEffort effort) {
  const auto found = detector.detect(gray, effort);
  return found && isWholeChessboard(gray, detector.board(), *found);
}

BoardDescription chessboardOf(const cv::Size& size, const BoardDescription& requested) {
  BoardDescription board;
  board.columns = size.width;
  board.rows = size.height;
  board.squareSize = requested.squareSize;
  board.isInverted = requested.kind == KindOfBoard::Chessboard && requested.isInverted;
  return isSameBoard(board, requested) ? requested : board; // columns and rows as requested
}

/// Chessboards suggested by single images, the most frequent sizes first.
std::vector<BoardDescription>
mostFrequentSizes(const std::vector<std::optional<ChessboardSuggestion>>& sizes,
                  const BoardDescription& requested) {
  std::map<std::pair<int, int>, int> votes;
  for (const auto& size : sizes) {
    if (size && size->isWhole) {
      ++votes[{size->innerCorners.width, size->innerCorners.height}];
    }
  }
  std::vector<std::pair<int, BoardDescription>> ranked;
  for (const auto& [size, count] : votes) {
    const auto board = chessboardOf({size.first, size.second}, requested);
    ranked.emplace_back(count, board);
  }
  std::ranges::stable_sort(ranked, [](const auto& one, const auto& other) {
    return std::pair(one.first, one.second.cornerCount()) >
           std::pair(other.first, other.second.cornerCount());
  });
  std::vector<BoardDescription> boards;
  for (const auto& [count, board] : ranked) {
    if (boards.size() < kMostSizes && checkBoard(board)) {
      boards.push_back(board);
    }
  }
  return boards;
}

/// The chessboards, or nothing when canceled.
std::optional<std::vector<BoardGuess>> chessboardGuesses(const std::vector<cv::Mat>& images,
                                                         const BoardDescription& requested,
                                                         const CalibrationProgress& progress) {
  std::vector<std::optional<ChessboardSuggestion>> sizes;
  for (std::size_t k = 0; k < images.size(); ++k) {
    if (!reportProgress(progress, CalibrationStage::BoardDetection, kReadingShare)) {
      return std::nullopt;
    }
    sizes.push_back(suggestChessboard(images[k]));
  }
  const auto suggested = static_cast<int>(
      std::ranges::count_if(sizes, [](const auto& size) { return size && size->isWhole; }));
  std::vector<BoardGuess> guesses;
  for (const BoardDescription& board : mostFrequentSizes(sizes, requested)) {
    BoardGuess guess{board, false, static_cast<int>(images.size()), 0, 0};
    const BoardDetector detector(board);
    int failed = 0;
    for (std::size_t k = 0; k < images.size(); ++k) {
      if (!reportProgress(progress, CalibrationStage::BoardDetection,
                          kReadingShare + (1.0 - kReadingShare) * static_cast<double>(k) /
                                              static_cast<double>(images.size()))) {
        return std::nullopt;
      }
      // Looking in vain costs the most time, and a few corners are easily found in anything.
      const bool same = sizes[k] && sizes[k]->isWhole &&
                        isSameBoard(board, chessboardOf(sizes[k]->innerCorners, requested));
      bool shown = sizes[k] && (same || board.cornerCount() >= kSurelyChessboard) &&
                   showsChessboard(images[k], detector, DetectionEffort::Live);
      if (!shown && same && failed < kMostFailures) {
        shown = showsChessboard(images[k], detector, DetectionEffort::Exact);
        failed += shown ? 0 : 1;
      }
      if (shown) {
        ++guess.imageCount;
        guess.cornerCount += board.cornerCount();
      }
    }
    if (board.cornerCount() >= kSurelyChessboard ||
        guess.imageCount >= kChessboardConfirmingImages) {
      guesses.push_back(guess);
    }
    if (2 * guess.imageCount > suggested) {
      break; // the other sizes are mistakes
    }
  }
  return guesses;
}

} // namespace

cv::Mat reducedGrayImage(const cv::Mat& image) {
  cv::Mat gray = image;
  if (image.channels() == 3) {
    cv::cvtColor(image, gray, cv::COLOR_BGR2GRAY);
  }
  if (gray.cols > kGuessWidth) {
    const double scale = static_cast<double>(kGuessWidth) / gray.cols;
    cv::Mat reduced;
    cv::resize(gray, reduced, {}, scale, scale, cv::INTER_AREA);
    return reduced;
  }
  return gray;
}

Result<std::vector<BoardGuess>> guessBoards(const std::vector<cv::Mat>& images,
                                            const BoardDescription& requested,
                                            const CalibrationProgress& progress) {
  std::vector<cv::Mat> searched;
  searched.reserve(images.size());
  for (const cv::Mat& image : images) {
    searched.push_back(reducedGrayImage(image));
  }
  auto guesses = charucoGuesses(searched, requested, progress);
  const auto isSeen = [](const BoardGuess& guess) { return guess.imageCount > 0; };
  if (guesses && std::ranges::none_of(*guesses, isSeen)) {
    // Only then: a ChArUco board has the corners of a chessboard too.
    guesses = chessboardGuesses(searched, requested, progress);
  }
  if (!guesses) {
    return canceledError();
  }
  std::erase_if(*guesses, [&](const BoardGuess& guess) { return !isSeen(guess); });
  std::ranges::stable_sort(*guesses, std::ranges::greater{}, &BoardGuess::cornerCount);
  return std::move(*guesses);
}

bool isSameBoard(const BoardDescription& one, const BoardDescription& other) {
  if (one.kind != other.kind) {
    return false;
  }
  if (one.kind == KindOfBoard::Chessboard) {
    return std::minmax(one.columns, one.rows) == std::minmax(other.columns, other.rows);
  }
  return one.columns == other.columns && one.rows == other.rows &&
         one.isBlack(0, 0) == other.isBlack(0, 0) && one.isInverted == other.isInverted &&
         codeOf(one.dictionary) == codeOf(other.dictionary);
}

std::string describeGuess(const BoardGuess& guess) {
  const BoardDescription& board = guess.board;
  std::string text =
      board.kind == KindOfBoard::Chessboard
          ? fmt::format("chessboard of {} x {} inner corners", board.columns, board.rows)
          : fmt::format("ChArUco board of {} x {} squares, {}", board.columns, board.rows,
                        board.dictionary);
  text += board.usesLegacyLayout ? ", legacy layout" : "";
  text += board.isInverted ? ", black and white exchanged" : "";
  text += guess.isMirrored ? ", mirrored" : "";
  return text;
}

std::string guessAdviceSentence(const BoardGuess& guess) {
  return fmt::format("{} of {} images searched seem to show a {}: {}use --board {}",
                     guess.imageCount, guess.searchedImageCount, describeGuess(guess),
                     guess.isMirrored ? "mirror the images (mirror = true in the project) and "
                                      : "",
                     boardText(guess.board));
}

} // namespace dewpoint::calibration
