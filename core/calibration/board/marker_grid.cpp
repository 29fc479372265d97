// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/marker_grid.h"

#include "core/base/statistics.h"

#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr int kMostGridColumns = 40;
constexpr std::size_t kLeastMarkersAtPlace = 4; ///< that determine a homography
constexpr double kPlaceTolerance = 0.15;        ///< squares: a lens bends the grid
/// How far the corners of a marker may be from where its size and the grid put them, as a part of
/// half its side.
constexpr double kCornerTolerance = 0.25;
constexpr double kLeastMarkerPart = 0.3;
constexpr double kMostMarkerPart = 0.97;
constexpr std::size_t kMostEqualGrids = 3;

/// Column and row of the squares with markers 0 to `lastId`.
std::vector<cv::Point> squaresWithMarkers(int columns, bool isFirstSquareWhite, int lastId) {
  std::vector<cv::Point> squares;
  for (int row = 0; static_cast<int>(squares.size()) <= lastId; ++row) {
    for (int column = 0; column < columns; ++column) {
      if ((column + row) % 2 == (isFirstSquareWhite ? 0 : 1)) {
        squares.emplace_back(column, row);
      }
    }
  }
  return squares;
}

cv::Point2f middleOfSquare(const cv::Point& square) {
  return {static_cast<float>(square.x) + 0.5F, static_cast<float>(square.y) + 0.5F};
}

/// Where the diagonals of a marker cross: its center also in a slanted view.
cv::Point2f crossingOfDiagonals(const ReadMarker& marker) {
  const auto& c = marker.corners;
  const cv::Point2f down = c[2] - c[0];
  const cv::Point2f up = c[1] - c[3];
  const double area = down.cross(up);
  if (area == 0.0) {
    return (c[0] + c[2]) / 2.0F;
  }
  return c[0] + down * static_cast<float>((c[3] - c[0]).cross(up) / area);
}

/// Side of a marker in squares, if it lies along the grid at the given place.
std::optional<double> sideAtPlace(const ReadMarker& marker, const cv::Mat& gridFromImage,
                                  const cv::Point2f& middle) {
  static constexpr std::array<std::array<float, 2>, 4> kSigns{
      {{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}}};
  const std::vector<cv::Point2f> corners(marker.corners.begin(), marker.corners.end());
  std::vector<cv::Point2f> onGrid;
  cv::perspectiveTransform(corners, onGrid, gridFromImage);
  cv::Point2f center(0.0F, 0.0F);
  for (const cv::Point2f& corner : onGrid) {
    center += corner / 4.0F;
  }
  float half = 0.0F;
  for (std::size_t k = 0; k < 4; ++k) {
    const cv::Point2f offset = onGrid[k] - center;
    half += (kSigns[k][0] * offset.x + kSigns[k][1] * offset.y) / 8.0F;
  }
  if (!(cv::norm(center - middle) < kPlaceTolerance && 2.0F * half > kLeastMarkerPart &&
        2.0F * half < kMostMarkerPart)) {
    return std::nullopt;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const cv::Point2f expected = center + cv::Point2f(kSigns[k][0] * half, kSigns[k][1] * half);
    if (cv::norm(onGrid[k] - expected) > kCornerTolerance * half) {
      return std::nullopt;
    }
  }
  return 2.0 * half;
}

/// The markers of one image at their places.
struct PlacedMarkers {
  std::vector<int> ids;
  std::vector<double> sides; ///< in squares
};

PlacedMarkers markersAtPlace(const std::vector<ReadMarker>& markers,
                             const std::vector<cv::Point>& squares) {
  PlacedMarkers placed;
  if (markers.size() < kLeastMarkersAtPlace) {
    return placed;
  }
  std::vector<cv::Point2f> image;
  std::vector<cv::Point2f> grid;
  for (const ReadMarker& marker : markers) {
    image.push_back(crossingOfDiagonals(marker));
    grid.push_back(middleOfSquare(squares[static_cast<std::size_t>(marker.id)]));
  }
  const cv::Mat map = cv::findHomography(image, grid, cv::RANSAC, kPlaceTolerance);
  for (std::size_t k = 0; !map.empty() && k < markers.size(); ++k) {
    if (const auto side = sideAtPlace(markers[k], map, grid[k])) {
      placed.ids.push_back(markers[k].id);
      placed.sides.push_back(*side);
    }
  }
  return placed.ids.size() < kLeastMarkersAtPlace ? PlacedMarkers{} : placed;
}

MarkerGrid gridAsSeen(const std::vector<std::vector<ReadMarker>>& images, int columns,
                      bool isFirstSquareWhite, int lastId) {
  MarkerGrid grid{columns, 0, isFirstSquareWhite, 0.0, 0, 0};
  const auto squares = squaresWithMarkers(columns, isFirstSquareWhite, lastId);
  std::vector<double> sides;
  for (const auto& markers : images) {
    const auto placed = markersAtPlace(markers, squares);
    grid.imageCount += placed.ids.empty() ? 0 : 1;
    grid.markerCount += static_cast<int>(placed.ids.size());
    sides.insert(sides.end(), placed.sides.begin(), placed.sides.end());
    for (const int id : placed.ids) {
      grid.rows = std::max(grid.rows, squares[static_cast<std::size_t>(id)].y + 1);
    }
  }
  if (!sides.empty()) {
    grid.markerToSquareRatio = upperMedian(std::move(sides));
  }
  if (isFirstSquareWhite && grid.rows % 2 != 0) {
    ++grid.rows; // only boards with even rows begin with a white square: the last was not seen
  }
  return grid;
}

} // namespace

std::vector<MarkerGrid> findMarkerGrids(const std::vector<std::vector<ReadMarker>>& images) {
  int lastId = -1;
  std::size_t most = 0;
  for (const auto& markers : images) {
    most = std::max(most, markers.size());
    lastId = markers.empty() ? lastId : std::max(lastId, markers.back().id); // in their order
  }
  std::vector<MarkerGrid> best;
  for (int columns = 2; most >= kLeastMarkersAtPlace && columns <= kMostGridColumns; ++columns) {
    for (const bool isFirstSquareWhite : {false, true}) {
      MarkerGrid grid = gridAsSeen(images, columns, isFirstSquareWhite, lastId);
      if (grid.imageCount == 0 || (!best.empty() && grid.markerCount < best.front().markerCount)) {
        continue;
      }
      if (!best.empty() && grid.markerCount > best.front().markerCount) {
        best.clear();
      }
      if (best.size() < kMostEqualGrids) {
        best.push_back(grid);
      }
    }
  }
  return best;
}

} // namespace dewpoint::calibration
