// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board_miss.h"

#include "core/calibration/board/chessboard_size.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace dewpoint::calibration {
namespace {

// Chosen so that nothing is called blurred or too small that a user would not see so; not measured.
constexpr double kBlurredEdgePx = 6.0;   ///< the sharpest edges of a sharp image are 2 px wide
constexpr double kLargestSmallPx = 16.0; ///< larger squares are found as they are
constexpr int kEnlargement = 2;
constexpr int kMostEnlargedWidth = 2600; ///< pixels: a wider image takes too long

// How the sharpest edges of an image are measured.
constexpr int kEdgeWindow = 15; ///< pixels: an edge much wider is measured in a smaller image
constexpr double kMeasuredWidthPx =
    6.0;                              ///< the widest edge that such a window holds with both sides
constexpr int kLeastReducedSide = 40; ///< pixels of an image made smaller
constexpr float kLeastEdgeContrast = 40.0F; ///< gray levels
constexpr std::size_t kLeastSamples = 20;   ///< edges
constexpr std::size_t kSharpestPart = 10;   ///< one of so many edges is sharper

cv::Mat rescaled(const cv::Mat& image, double scale) {
  cv::Mat result;
  cv::resize(image, result, {}, scale, scale, scale < 1.0 ? cv::INTER_AREA : cv::INTER_CUBIC);
  return result;
}

cv::Mat grayImage(const cv::Mat& image) {
  cv::Mat gray = image;
  if (image.channels() == 3) {
    cv::cvtColor(image, gray, cv::COLOR_BGR2GRAY);
  }
  return gray;
}

/// The widths of the edges in an image along its rows: contrast around the steepest places, divided
/// by the slope.
std::vector<float> edgeWidths(const cv::Mat& gray) {
  cv::Mat level;
  gray.convertTo(level, CV_32F);
  const cv::Mat window = cv::getStructuringElement(cv::MORPH_RECT, {kEdgeWindow, 1});
  cv::Mat highest;
  cv::Mat lowest;
  cv::dilate(level, highest, window);
  cv::erode(level, lowest, window);
  cv::Mat slope(level.size(), CV_32F, cv::Scalar(0.0));
  for (int row = 1; row + 1 < level.rows; ++row) {
    for (int column = 1; column + 1 < level.cols; ++column) {
      const float across =
          std::abs(level.at<float>(row, column + 1) - level.at<float>(row, column - 1));
      const float down =
          std::abs(level.at<float>(row + 1, column) - level.at<float>(row - 1, column));
      slope.at<float>(row, column) = across >= 2.0F * down ? 0.5F * across : 0.0F;
    }
  }
  cv::Mat steepest;
  cv::dilate(slope, steepest, window);
  std::vector<float> widths;
  for (int row = 0; row < level.rows; ++row) {
    for (int column = 0; column < level.cols; ++column) {
      const float contrast = highest.at<float>(row, column) - lowest.at<float>(row, column);
      const float at = slope.at<float>(row, column);
      if (contrast >= kLeastEdgeContrast && at > 0.0F && at >= steepest.at<float>(row, column)) {
        widths.push_back(contrast / at);
      }
    }
  }
  return widths;
}

/// The width of the sharpest edges along the rows of an image, pixels; 0: it has too few edges.
double sharpestEdges(const cv::Mat& gray) {
  double width = 0.0;
  for (int by = 1; std::min(gray.cols, gray.rows) / by >= kLeastReducedSide; by *= 2) {
    auto widths = edgeWidths(by == 1 ? gray : rescaled(gray, 1.0 / by));
    if (widths.size() < kLeastSamples) {
      return width;
    }
    const auto at = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / kSharpestPart);
    std::ranges::nth_element(widths, at);
    width = by * static_cast<double>(*at);
    if (*at < kMeasuredWidthPx) {
      return width;
    }
  }
  return width;
}

/// A camera or board that moves blurs only the edges across its motion.
double blurOf(const cv::Mat& gray) {
  cv::Mat upright;
  cv::transpose(gray, upright);
  return std::max(sharpestEdges(gray), sharpestEdges(upright));
}

/// The side of the squares: the smallest distance between corners that are neighbors in a row.
double squareSide(const BoardDescription& board, const BoardDetection& found) {
  double side = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < found.ids.size(); ++k) {
    if (found.ids[k + 1] == found.ids[k] + 1 &&
        found.ids[k + 1] % board.cornerColumns() != 0) { // NOLINT: in one row
      side = std::min(side, (found.pixels[k + 1] - found.pixels[k]).norm());
    }
  }
  return side;
}

/// The corners of the part of the board that the image shows; 0: none that is surely of the board.
int cornersOfPart(const BoardDetector& detector, const cv::Mat& image) {
  const BoardDescription& board = detector.board();
  if (board.kind == BoardDescription::Kind::Charuco) {
    return detector.countCorners(image);
  }
  const auto part = suggestChessboard(grayImage(image));
  const bool fits = part && !part->isWhole && // a whole one is another board
                    part->innerCorners.width <= std::max(board.columns, board.rows) &&
                    part->innerCorners.height <= std::min(board.columns, board.rows);
  return fits ? part->innerCorners.area() : 0;
}

} // namespace

BoardMiss diagnoseMissedBoard(const BoardDetector& detector, const cv::Mat& image) {
  BoardMiss miss;
  if (image.cols * kEnlargement <= kMostEnlargedWidth) {
    // Exact: with less effort, it would be reduced again.
    const auto found = detector.detect(rescaled(image, kEnlargement), DetectionEffort::Exact);
    const double side = found ? squareSide(detector.board(), *found) / kEnlargement
                              : std::numeric_limits<double>::infinity();
    if (side < kLargestSmallPx) {
      miss.reason = BoardMiss::Reason::TooSmall;
      miss.squareSizePx = side;
      return miss;
    }
  }
  if (const double width = blurOf(grayImage(image)); width > kBlurredEdgePx) {
    miss.reason = BoardMiss::Reason::Blurred;
    miss.edgeWidthPx = width;
    return miss;
  }
  miss.cornerCount = cornersOfPart(detector, image);
  if (miss.cornerCount > 0 && miss.cornerCount < detector.board().cornerCount()) {
    miss.reason = BoardMiss::Reason::TooFewCorners;
  } else {
    miss.cornerCount = 0;
  }
  return miss;
}

std::string missReasonText(const BoardMiss& miss) {
  switch (miss.reason) {
  case BoardMiss::Reason::TooFewCorners:
    return fmt::format("too few corners: {}", miss.cornerCount);
  case BoardMiss::Reason::Blurred:
    return fmt::format("blurred, edges of {:.0f} px", miss.edgeWidthPx);
  case BoardMiss::Reason::TooSmall:
    return fmt::format("too small, squares of {:.0f} px", miss.squareSizePx);
  case BoardMiss::Reason::Unknown:
    break;
  }
  return {};
}

} // namespace dewpoint::calibration
