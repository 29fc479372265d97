// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/charuco_corners.h"

#include "core/calibration/board/corner_refinement.h"
#include "core/calibration/board/marker_dictionary.h"

#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr std::size_t kNearestMarkers = 3; // over so few squares a lens is as good as straight
constexpr double kWindowPart = 0.75;       // of the plain white between a corner and a marker
/// Half the window's side, pixels.
constexpr int kLargestWindow = 5;
constexpr double kLeastContrast = 15.0; // gray levels between the black and the white squares

/// Corners around one that show where it should be, ...
constexpr std::size_t kNeighbors = 8;
/// ... and the fewest that do.
constexpr std::size_t kLeastNeighbors = 6;
/// Pixels that a corner may be off from there, or ...
constexpr double kMostOffPx = 1.0;
constexpr double kMostOffPart = 0.03; // of the spacing

constexpr double kTieDistance = 0.01; // squares

struct SeenMarker {
  cv::Point2d middle; ///< on the board, in squares
  std::vector<cv::Point2f> page;
  std::vector<cv::Point2f> image;
};

std::vector<SeenMarker> seenMarkers(const cv::Mat& gray, const BoardDescription& board,
                                    const std::vector<std::pair<int, int>>& squares) {
  const auto [outlines, ids, others] = MarkerDictionary(board.dictionary).detect(gray);
  std::vector<SeenMarker> seen;
  const float half = static_cast<float>(0.5 * board.markerSize / board.squareSize);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (ids[k] >= static_cast<int>(squares.size()) || std::ranges::count(ids, ids[k]) > 1) {
      continue; // of another board, or seen twice: one of them is wrong
    }
    const auto [column, row] = squares[static_cast<std::size_t>(ids[k])];
    const cv::Point2f middle(static_cast<float>(column) + 0.5F, static_cast<float>(row) + 0.5F);
    seen.push_back({middle,
                    {middle + cv::Point2f(-half, -half), middle + cv::Point2f(half, -half),
                     middle + cv::Point2f(half, half), middle + cv::Point2f(-half, half)},
                    outlines[k]});
  }
  // The detector works in threads and lists markers as they come: the same order every time.
  std::ranges::sort(seen, {}, [](const SeenMarker& marker) {
    return std::pair(marker.middle.y, marker.middle.x);
  });
  return seen;
}

/// Image from page, in squares, near a corner: from the markers next to it. Nothing when no marker
/// touches the corner's squares.
std::optional<cv::Matx33d> localHomography(std::vector<SeenMarker> markers,
                                           const cv::Point2d& corner) {
  const auto nearer = [&](const SeenMarker& one, const SeenMarker& other) {
    return cv::norm(one.middle - corner) < cv::norm(other.middle - corner);
  };
  std::ranges::sort(markers, nearer);
  if (markers.size() < 2 || cv::norm(markers.front().middle - corner) > 1.0) {
    return std::nullopt;
  }
  // All that are as near as the last one: which of equals comes first means nothing.
  const double reach = markers.size() > kNearestMarkers
                           ? cv::norm(markers[kNearestMarkers - 1].middle - corner) + kTieDistance
                           : std::numeric_limits<double>::max();
  std::erase_if(markers,
                [&](const SeenMarker& marker) { return cv::norm(marker.middle - corner) > reach; });
  std::vector<cv::Point2f> page;
  std::vector<cv::Point2f> image;
  for (const SeenMarker& marker : markers) {
    page.insert(page.end(), marker.page.begin(), marker.page.end());
    image.insert(image.end(), marker.image.begin(), marker.image.end());
  }
  const cv::Mat map = cv::findHomography(page, image);
  return map.empty() ? std::nullopt : std::optional(cv::Matx33d(map));
}

cv::Point2f mapped(const cv::Matx33d& map, const cv::Point2d& point) {
  const cv::Vec3d image = map * cv::Vec3d(point.x, point.y, 1.0);
  return {static_cast<float>(image[0] / image[2]), static_cast<float>(image[1] / image[2])};
}

/// Whether black and white squares alternate around a corner, as they do where nothing hides it.
bool looksLikeCorner(const cv::Mat& gray, const BoardDescription& board, const cv::Matx33d& map,
                     const cv::Point2d& corner, double gap) {
  const auto level = [&](double x, double y) {
    const cv::Point2f at = mapped(map, corner + cv::Point2d(x * gap, y * gap));
    return grayAt(gray, at.x, at.y);
  };
  const double mainDiagonal[] = {level(-0.6, -0.6), level(0.6, 0.6)};
  const double other[] = {level(0.6, -0.6), level(-0.6, 0.6)};
  const bool blackMain =
      board.isBlack(static_cast<int>(corner.x) - 1, static_cast<int>(corner.y) - 1);
  const auto& black = blackMain ? mainDiagonal : other;
  const auto& white = blackMain ? other : mainDiagonal;
  return std::min(white[0], white[1]) - std::max(black[0], black[1]) > kLeastContrast;
}

/// Leaves out corners that lie elsewhere than their neighbors say: drawn onto a marker's edge.
void dropInconsistent(const BoardDescription& board, std::vector<int>& ids,
                      std::vector<cv::Point2f>& corners) {
  const auto onBoard = [&](int id) {
    return cv::Point2f(static_cast<float>(id % board.cornerColumns()),
                       static_cast<float>(id / board.cornerColumns())); // NOLINT: whole rows
  };
  std::vector<int> keptIds;
  std::vector<cv::Point2f> kept;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    std::vector<std::size_t> near(ids.size());
    std::iota(near.begin(), near.end(), std::size_t{0});
    std::ranges::stable_sort(near, {}, [&](std::size_t other) {
      return cv::norm(onBoard(ids[other]) - onBoard(ids[k]));
    });
    near.erase(near.begin()); // itself
    near.resize(std::min(near.size(), kNeighbors));
    std::vector<cv::Point2f> page;
    std::vector<cv::Point2f> image;
    for (const std::size_t other : near) {
      page.push_back(onBoard(ids[other]));
      image.push_back(corners[other]);
    }
    const cv::Mat map =
        near.size() < kLeastNeighbors ? cv::Mat() : cv::findHomography(page, image, cv::LMEDS);
    // A lens bends what is large in the image more than that.
    const double spacing = near.empty() ? 0.0 : cv::norm(corners[near.front()] - corners[k]);
    if (map.empty() || cv::norm(mapped(cv::Matx33d(map), onBoard(ids[k])) - corners[k]) <
                           std::max(kMostOffPx, kMostOffPart * spacing)) {
      keptIds.push_back(ids[k]);
      kept.push_back(corners[k]);
    }
  }
  ids = std::move(keptIds);
  corners = std::move(kept);
}

} // namespace

void findCharucoCorners(const cv::Mat& gray, const BoardDescription& board,
                        const std::vector<std::pair<int, int>>& markerSquares,
                        std::vector<int>& ids, std::vector<cv::Point2f>& corners) {
  const auto markers = seenMarkers(gray, board, markerSquares);
  const double gap = 0.5 * (1.0 - board.markerSize / board.squareSize);
  for (int id = 0; id < board.cornerCount(); ++id) {
    const int column = id % board.cornerColumns() + 1;
    const int row = id / board.cornerColumns() + 1;
    const cv::Point2d corner(column, row);
    const auto map = localHomography(markers, corner);
    if (!map) {
      continue;
    }
    const cv::Point2f guess = mapped(*map, corner);
    const double gapPx = std::min(cv::norm(mapped(*map, corner + cv::Point2d(gap, 0)) - guess),
                                  cv::norm(mapped(*map, corner + cv::Point2d(0, gap)) - guess));
    const int window = std::clamp(static_cast<int>(kWindowPart * gapPx), 2, kLargestWindow);
    const cv::Rect_<float> inside(static_cast<float>(window) + 1.0F,
                                  static_cast<float>(window) + 1.0F,
                                  static_cast<float>(gray.cols - 2 * window - 2),
                                  static_cast<float>(gray.rows - 2 * window - 2));
    if (!inside.contains(guess) || !looksLikeCorner(gray, board, *map, corner, gap)) {
      continue;
    }
    std::vector<cv::Point2f> refined{guess};
    refineCorners(gray, window, 60, 1e-3, refined);
    if (cv::norm(refined[0] - guess) < std::max(2.0, 0.5 * window)) {
      ids.push_back(id);
      corners.push_back(refined[0]);
    }
  }
  dropInconsistent(board, ids, corners);
}

} // namespace dewpoint::calibration
