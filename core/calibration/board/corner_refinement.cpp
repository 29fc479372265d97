// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/corner_refinement.h"

#include "core/base/statistics.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr double kLeastBoardContrast = 20.0; // gray levels; less is no edge of a board
constexpr double kEdgeStep = 0.25;           // pixels between two samples across an edge
/// Edges whose width is measured: more cost time.
constexpr int kMostEdges = 60;

/// Width of the edge through the middle between two corners; 0 when there is none.
double widthAcross(const cv::Mat& gray, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                   double reach) {
  const Eigen::Vector2d along = to - from;
  const double half = std::min(reach * along.norm(), 12.0);
  const Eigen::Vector2d across = Eigen::Vector2d(-along.y(), along.x()).normalized();
  const Eigen::Vector2d middle = 0.5 * (from + to);
  double least = 255.0;
  double most = 0.0;
  double steepest = 0.0;
  double before = 0.0;
  for (double t = -half; t <= half; t += kEdgeStep) {
    const Eigen::Vector2d at = middle + t * across;
    const double level = grayAt(gray, at.x(), at.y());
    steepest = t > -half ? std::max(steepest, std::abs(level - before) / kEdgeStep) : 0.0;
    before = level;
    least = std::min(least, level);
    most = std::max(most, level);
  }
  return most - least > kLeastBoardContrast ? (most - least) / steepest : 0.0;
}

} // namespace

double grayAt(const cv::Mat& gray, double column, double row) {
  const double x = std::clamp(column, 0.0, gray.cols - 1.001);
  const double y = std::clamp(row, 0.0, gray.rows - 1.001);
  const int left = static_cast<int>(x);
  const int top = static_cast<int>(y);
  const double u = x - left;
  const double v = y - top;
  const auto* above = gray.ptr<unsigned char>(top) + left;
  const auto* below = gray.ptr<unsigned char>(top + 1) + left;
  return (1.0 - v) * ((1.0 - u) * above[0] + u * above[1]) +
         v * ((1.0 - u) * below[0] + u * below[1]);
}

void refineCorners(const cv::Mat& gray, int halfWindow, int steps, double tolerance,
                   std::vector<cv::Point2f>& corners) {
  const cv::TermCriteria until(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, steps, tolerance);
  cv::cornerSubPix(gray, corners, {halfWindow, halfWindow}, {-1, -1}, until);
}

double smallestSpacing(const std::vector<cv::Point2f>& grid, int columns) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t k = 0; k < grid.size(); ++k) {
    if ((k + 1) % static_cast<std::size_t>(columns) != 0 && k + 1 < grid.size()) {
      least = std::min(least, cv::norm(grid[k + 1] - grid[k]));
    }
    if (k + static_cast<std::size_t>(columns) < grid.size()) {
      least = std::min(least, cv::norm(grid[k + static_cast<std::size_t>(columns)] - grid[k]));
    }
  }
  return least;
}

double measureEdgeWidth(const cv::Mat& gray, const BoardDescription& board,
                        const BoardDetection& detection, double reach) {
  std::map<int, Eigen::Vector2d> places;
  for (std::size_t k = 0; k < detection.ids.size(); ++k) {
    places[detection.ids[k]] = detection.pixels[k];
  }
  std::vector<double> widths;
  const int columns = board.cornerColumns();
  const std::size_t stride = 1 + places.size() * 2 / kMostEdges;
  for (std::size_t k = 0; k < detection.ids.size(); k += stride) {
    const int id = detection.ids[k];
    for (const int next : {(id + 1) % columns != 0 ? id + 1 : -1, id + columns}) {
      const auto found = places.find(next);
      const double width = found == places.end()
                               ? 0.0
                               : widthAcross(gray, detection.pixels[k], found->second, reach);
      if (width > 0.0) {
        widths.push_back(width);
      }
    }
  }
  return upperMedian(std::move(widths));
}

} // namespace dewpoint::calibration
