// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board_detection.h"

#include "core/base/statistics.h"
#include "core/calibration/board/charuco_corners.h"
#include "core/calibration/board/chessboard_corners.h"
#include "core/calibration/board/corner_refinement.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <numeric>

namespace dewpoint::calibration {
namespace {

constexpr std::size_t kLeastCharucoCorners = 4;

/// click_aids.cpp has its own, which leaves gray images as they are: no room that both may include
/// knows images.
cv::Mat grayOf(const cv::Mat& image, bool inverted) {
  cv::Mat gray = image;
  if (image.channels() == 3) {
    cv::cvtColor(image, gray, cv::COLOR_BGR2GRAY);
  }
  return inverted ? cv::Mat(~gray) : gray;
}

} // namespace

BoardDetector::BoardDetector(const BoardDescription& board) : board_(board) {
  for (int k = 0; board.kind == BoardDescription::Kind::Charuco && k < board.columns * board.rows;
       ++k) {
    if (!board.isBlack(k % board.columns, k / board.columns)) {
      markerSquares_.emplace_back(k % board.columns, k / board.columns);
    }
  }
}

std::optional<BoardDetection> BoardDetector::detect(const cv::Mat& image,
                                                    DetectionEffort effort) const {
  BoardDetection found;
  std::vector<cv::Point2f> corners;
  double reach = 0.35; // of a square: where the page is plain beside an edge
  const bool charuco = board_.kind == BoardDescription::Kind::Charuco;
  const cv::Mat gray = grayOf(image, charuco && board_.isInverted);
  try {
    if (charuco) {
      reach = 0.5 * (1.0 - board_.markerSize / board_.squareSize);
      findCharucoCorners(gray, board_, markerSquares_, found.ids, corners);
      if (corners.size() < kLeastCharucoCorners) {
        return std::nullopt;
      }
    } else {
      auto all = chessboardCorners(gray, board_, effort);
      if (!all) {
        return std::nullopt;
      }
      corners = std::move(*all);
      found.ids.resize(corners.size());
      std::iota(found.ids.begin(), found.ids.end(), 0);
    }
  } catch (const cv::Exception&) {
    return std::nullopt; // its own algorithms give up on some pictures that way
  }
  for (const cv::Point2f& corner : corners) {
    found.pixels.emplace_back(corner.x, corner.y);
  }
  found.edgeWidthPx = measureEdgeWidth(gray, board_, found, reach);
  return found;
}

int BoardDetector::countCorners(const cv::Mat& image) const {
  if (board_.kind != BoardDescription::Kind::Charuco) {
    return 0;
  }
  std::vector<int> ids;
  std::vector<cv::Point2f> corners;
  try {
    findCharucoCorners(grayOf(image, board_.isInverted), board_, markerSquares_, ids, corners);
  } catch (const cv::Exception&) {
    return 0;
  }
  return static_cast<int>(corners.size());
}

std::optional<double> motionBetween(const BoardDetection& one, const BoardDetection& other) {
  std::vector<double> distances;
  std::size_t k = 0;
  for (std::size_t i = 0; i < one.ids.size(); ++i) {
    while (k < other.ids.size() && other.ids[k] < one.ids[i]) {
      ++k;
    }
    if (k < other.ids.size() && other.ids[k] == one.ids[i]) {
      distances.push_back((one.pixels[i] - other.pixels[k]).norm());
    }
  }
  if (distances.empty()) {
    return std::nullopt;
  }
  return upperMedian(std::move(distances));
}

BoardDetection rotated(const BoardDetection& detection, const BoardDescription& board,
                       int quarterTurns) {
  const auto order = rotatedOrder(detection.pixels.size(), board.cornerColumns(), quarterTurns);
  BoardDetection result = detection;
  for (std::size_t k = 0; k < order.size(); ++k) {
    result.pixels[k] = detection.pixels[order[k]];
  }
  return result;
}

} // namespace dewpoint::calibration
