// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/chessboard_corners.h"

#include "core/calibration/board/corner_refinement.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <numeric>

namespace dewpoint::calibration {
namespace {

using Grid = std::vector<cv::Point2f>;

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr int kLiveWidth = 640;   // pixels: a wider picture is made smaller to look for the board
constexpr int kSampleWindow = 11; // as in OpenCV's sample programs
constexpr double kSpacingPart = 0.4; // of the spacing: no other corner within reach
/// Half the window's side, pixels.
constexpr int kLeastWindow = 2;

/// A window that holds no neighboring corner.
void refineWithinSpacing(const cv::Mat& gray, int columns, Grid& corners) {
  const int window = std::clamp(static_cast<int>(kSpacingPart * smallestSpacing(corners, columns)),
                                kLeastWindow, kSampleWindow);
  refineCorners(gray, window, 60, 1e-3, corners);
}

/// The board seen whole in a picture made smaller or stretched, its corners in pixels of `gray`.
/// In a stretched picture they are refined at once.
bool findScaled(const cv::Mat& gray, const cv::Size& size, double scaleX, double scaleY,
                Grid& corners) {
  constexpr int kFlags =
      cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_FAST_CHECK;
  cv::Mat scaled = gray;
  if (scaleX != 1.0 || scaleY != 1.0) {
    cv::resize(gray, scaled, {}, scaleX, scaleY, scaleX < 1.0 ? cv::INTER_AREA : cv::INTER_CUBIC);
  }
  if (!cv::findChessboardCorners(scaled, size, corners, kFlags)) {
    return false;
  }
  if (scaleX > 1.0 || scaleY > 1.0) {
    refineWithinSpacing(scaled, size.width, corners);
  }
  for (cv::Point2f& corner : corners) { // centers of pixels lie at whole numbers
    corner.x = static_cast<float>((corner.x + 0.5) / scaleX - 0.5);
    corner.y = static_cast<float>((corner.y + 0.5) / scaleY - 0.5);
  }
  return true;
}

bool find(const cv::Mat& gray, const cv::Size& size, DetectionEffort effort, Grid& corners) {
  const bool live = effort == DetectionEffort::Live;
  const double scale = live ? std::min(1.0, static_cast<double>(kLiveWidth) / gray.cols) : 1.0;
  if (findScaled(gray, size, scale, scale, corners)) {
    if (effort == DetectionEffort::Sample) {
      refineCorners(gray, kSampleWindow, 30, 0.1, corners);
    } else {
      refineWithinSpacing(gray, size.width, corners);
    }
    return true;
  }
  if (live) {
    return false;
  }
  // A board seen at a grazing angle is flat in the image: stretched it is found, and refined
  // better.
  if (findScaled(gray, size, 1.0, 2.0, corners) || findScaled(gray, size, 2.0, 1.0, corners)) {
    return true;
  }
  // The slow one finds some boards that the other does not; its own corners are 0.03 px off where
  // the board is tilted (the test on rendered boards), so that all are refined alike.
  if (!cv::findChessboardCornersSB(gray, size, corners, 0)) {
    return false;
  }
  refineWithinSpacing(gray, size.width, corners);
  return true;
}

/// Positive when the square right below the first corner is black, as on a board counted rightly.
double firstSquareDarkness(const cv::Mat& gray, const Grid& grid, int columns) {
  double sum = 0.0;
  const int rows = static_cast<int>(grid.size()) / columns;
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column + 1 < columns; ++column) {
      const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(column);
      const auto below = at + static_cast<std::size_t>(columns);
      const cv::Point2f middle = (grid[at] + grid[at + 1] + grid[below] + grid[below + 1]) / 4.0F;
      const double level = grayAt(gray, middle.x, middle.y);
      sum += (row + column) % 2 == 0 ? -level : level;
    }
  }
  return sum;
}

/// How far rows run to the right in the image.
float rightward(const Grid& grid, int columns) {
  return grid[static_cast<std::size_t>(columns) - 1].x - grid.front().x + grid.back().x -
         grid[grid.size() - static_cast<std::size_t>(columns)].x;
}

bool isMirrored(const Grid& grid, int columns) {
  const cv::Point2f along = grid[static_cast<std::size_t>(columns) - 1] - grid.front();
  const cv::Point2f down = grid[grid.size() - static_cast<std::size_t>(columns)] - grid.front();
  return along.cross(down) < 0.0F;
}

/// Counts the corners as the board does: by its colors, and to the right where they leave a choice.
Grid ordered(const cv::Mat& gray, const BoardDescription& board, Grid grid) {
  const int columns = board.cornerColumns();
  if (isMirrored(grid, columns)) {
    for (auto row = grid.begin(); row != grid.end(); row += columns) {
      std::reverse(row, row + columns);
    }
  }
  Grid best;
  std::pair<bool, float> bestRank;
  for (int turns = 0; turns < 4; turns += columns == board.cornerRows() ? 1 : 2) {
    Grid candidate;
    for (const std::size_t at : rotatedOrder(grid.size(), columns, turns)) {
      candidate.push_back(grid[at]);
    }
    const double darkness = firstSquareDarkness(gray, candidate, columns);
    const std::pair rank((darkness > 0.0) != board.isInverted, rightward(candidate, columns));
    if (best.empty() || rank > bestRank) {
      best = std::move(candidate);
      bestRank = rank;
    }
  }
  return best;
}

} // namespace

std::vector<std::size_t> rotatedOrder(std::size_t cornerCount, int columns, int quarterTurns) {
  std::vector<std::size_t> order(cornerCount);
  std::iota(order.begin(), order.end(), std::size_t{0});
  auto width = static_cast<std::size_t>(columns);
  for (int turn = 0; turn < quarterTurns; ++turn) {
    const std::size_t height = cornerCount / width;
    std::vector<std::size_t> next;
    for (std::size_t column = width; column-- > 0;) {
      for (std::size_t row = 0; row < height; ++row) {
        next.push_back(order[row * width + column]);
      }
    }
    order = std::move(next);
    width = height;
  }
  return order;
}

std::optional<Grid> chessboardCorners(const cv::Mat& gray, const BoardDescription& board,
                                      DetectionEffort effort) {
  Grid corners;
  if (!find(gray, {board.columns, board.rows}, effort, corners) ||
      static_cast<int>(corners.size()) != board.cornerCount()) {
    return std::nullopt;
  }
  return ordered(gray, board, std::move(corners));
}

} // namespace dewpoint::calibration
