// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/chessboard_size.h"

#include "core/base/statistics.h"
#include "core/calibration/board/corner_refinement.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr int kSuggestionWidth = 640;       ///< pixels; wider images are reduced
constexpr double kOuterSample = 0.3;        ///< squares outside the outer corners
constexpr double kLeastSquareContrast = 10; ///< gray levels between neighboring squares
constexpr double kAlternatingPart = 0.95;   ///< of the pairs of neighbors on a board
constexpr double kContinuedContrast = 0.5;  ///< of the median contrast on the board
constexpr std::size_t kLeastPairsBeyond =
    2; ///< pairs of squares beside a board that say that it goes on

/// Squares of a detected chessboard in its image. Square (0, 0) is the one before the first corner.
class SquareLevels {
public:
  SquareLevels(const cv::Mat& gray, const BoardDescription& board, const BoardDetection& detection)
      : gray_(gray), columns_(board.cornerColumns() + 1), rows_(board.cornerRows() + 1) {
    std::vector<cv::Point2f> page;
    std::vector<cv::Point2f> image;
    for (std::size_t k = 0; k < detection.ids.size(); ++k) {
      const int id = detection.ids[k];
      page.emplace_back(static_cast<float>(id % board.cornerColumns()),
                        static_cast<float>(id / board.cornerColumns())); // NOLINT: whole rows
      image.emplace_back(static_cast<float>(detection.pixels[k].x()),
                         static_cast<float>(detection.pixels[k].y()));
    }
    map_ = cv::findHomography(page, image);
  }

  int columns() const { return columns_; }
  int rows() const { return rows_; }

  /// Gray level of a square; nothing outside the image.
  std::optional<double> level(int column, int row) const {
    const auto at = [](int square, int count) {
      return square == 0           ? -kOuterSample
             : square == count - 1 ? square - 1 + kOuterSample
                                   : square - 0.5;
    };
    if (map_.empty()) {
      return std::nullopt;
    }
    std::vector<cv::Point2f> point{
        {static_cast<float>(at(column, columns_)), static_cast<float>(at(row, rows_))}};
    cv::perspectiveTransform(point, point, map_);
    const cv::Rect_<float> inside(0.0F, 0.0F, static_cast<float>(gray_.cols - 1),
                                  static_cast<float>(gray_.rows - 1));
    return inside.contains(point[0]) ? std::optional(grayAt(gray_, point[0].x, point[0].y))
                                     : std::nullopt;
  }

  /// Differences between neighbors in a row, counted positive where they alternate as the pattern
  /// with a white square (0, 0) does.
  std::vector<double> contrasts() const {
    std::vector<double> all;
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        const auto here = level(column, row);
        for (const auto& other : {column + 1 < columns_ ? level(column + 1, row) : std::nullopt,
                                  row + 1 < rows_ ? level(column, row + 1) : std::nullopt}) {
          if (here && other) {
            all.push_back(((column + row) % 2 == 0 ? 1.0 : -1.0) * (*here - *other));
          }
        }
      }
    }
    return all;
  }

private:
  cv::Mat gray_;
  int columns_;
  int rows_;
  cv::Mat map_; ///< image from page, in squares from the first corner
};

/// Whether the squares of a line beside the board, given by their first one and a step, alternate
/// like the board (`sign`: +1 if its square (0, 0) is white).
bool patternGoesOn(const SquareLevels& squares, cv::Point from, const cv::Point& step, int count,
                   double leastContrast) {
  std::size_t pairs = 0;
  for (int k = 0; k + 1 < count; ++k, from += step) {
    const auto here = squares.level(from.x, from.y);
    const auto next = squares.level(from.x + step.x, from.y + step.y);
    if (!here || !next) {
      continue;
    }
    const double sign = (from.x + from.y) % 2 == 0 ? 1.0 : -1.0;
    if (sign * (*here - *next) * (leastContrast < 0.0 ? -1.0 : 1.0) < std::abs(leastContrast)) {
      return false;
    }
    ++pairs;
  }
  return pairs >= kLeastPairsBeyond;
}

/// Whether the pattern goes on beyond one of the four sides: what was detected is part of a board.
bool isPartOfABoard(const SquareLevels& squares, double medianContrast) {
  const double least = kContinuedContrast * medianContrast;
  const int columns = squares.columns();
  const int rows = squares.rows();
  return patternGoesOn(squares, {-1, 1}, {0, 1}, rows - 2, least) ||
         patternGoesOn(squares, {columns, 1}, {0, 1}, rows - 2, least) ||
         patternGoesOn(squares, {1, -1}, {1, 0}, columns - 2, least) ||
         patternGoesOn(squares, {1, rows}, {1, 0}, columns - 2, least);
}

} // namespace

std::optional<ChessboardSuggestion> suggestChessboard(const cv::Mat& gray) {
  cv::Mat reduced = gray;
  if (gray.cols > kSuggestionWidth) {
    const double scale = static_cast<double>(kSuggestionWidth) / gray.cols;
    cv::resize(gray, reduced, {}, scale, scale, cv::INTER_AREA);
  }
  std::vector<cv::Point2f> corners;
  cv::Mat meta; // one element for each corner
  try {
    if (!cv::findChessboardCornersSB(reduced, {3, 3}, corners, cv::CALIB_CB_LARGER, meta)) {
      return std::nullopt;
    }
  } catch (const cv::Exception&) {
    return std::nullopt; // its own algorithms give up on some pictures that way
  }
  BoardDescription grid;
  grid.columns = meta.cols;
  grid.rows = meta.rows;
  BoardDetection found;
  for (const cv::Point2f& corner : corners) {
    found.ids.push_back(static_cast<int>(found.ids.size()));
    found.pixels.emplace_back(corner.x, corner.y);
  }
  return ChessboardSuggestion{{std::max(meta.cols, meta.rows), std::min(meta.cols, meta.rows)},
                              isWholeChessboard(reduced, grid, found)};
}

bool isWholeChessboard(const cv::Mat& gray, const BoardDescription& board,
                       const BoardDetection& detection) {
  const SquareLevels squares(gray, board, detection);
  auto contrasts = squares.contrasts();
  if (contrasts.empty()) {
    return false;
  }
  const double median = upperMedian(contrasts);
  const double sign = median < 0.0 ? -1.0 : 1.0;
  const auto alternating = std::ranges::count_if(
      contrasts, [&](double contrast) { return sign * contrast > kLeastSquareContrast; });
  return static_cast<double>(alternating) >=
             kAlternatingPart * static_cast<double>(contrasts.size()) &&
         !isPartOfABoard(squares, median);
}

} // namespace dewpoint::calibration
