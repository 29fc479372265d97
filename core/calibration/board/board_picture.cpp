// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board_picture.h"

#include "core/calibration/board/marker_dictionary.h"
#include "core/geometry/ray.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::calibration {
namespace {

constexpr double kDarkLevel = 25.0;
constexpr double kLightLevel = 230.0;
constexpr double kGroundLevel = 128.0;

/// Where the cell of a table with `columns` columns is, row by row.
std::size_t indexOf(int column, int row, int columns) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
         static_cast<std::size_t>(column);
}

/// The cells of all markers a board needs, with their border, row by row.
std::vector<std::vector<char>> markerCells(const BoardDescription& board, int& cells) {
  const MarkerDictionary dictionary(board.dictionary);
  cells = dictionary.cellsPerRow() + 2;
  std::vector<std::vector<char>> markers;
  for (int id = 0; id < (board.columns * board.rows + 1) / 2 && id < dictionary.size(); ++id) {
    const cv::Mat bits = dictionary.cellsOf(id);
    std::vector<char> marker(indexOf(0, cells, cells), 1);
    for (int row = 0; row < bits.rows; ++row) {
      for (int column = 0; column < bits.cols; ++column) {
        marker[indexOf(column + 1, row + 1, cells)] =
            bits.at<unsigned char>(row, column) == 0 ? 1 : 0;
      }
    }
    markers.push_back(std::move(marker));
  }
  return markers;
}

} // namespace

BoardPattern::BoardPattern(const BoardDescription& board) : board_(board) {
  markerOfSquare_.assign(indexOf(0, board.squareRows(), board.squareColumns()), -1);
  if (board.kind != BoardDescription::Kind::Charuco) {
    return;
  }
  markers_ = markerCells(board, cells_);
  int marker = 0;
  for (int k = 0; k < board.columns * board.rows; ++k) {
    if (!board.isBlack(k % board.columns, k / board.columns)) {
      markerOfSquare_[static_cast<std::size_t>(k)] = marker++;
    }
  }
}

int BoardPattern::markerAt(int column, int row) const {
  return markerOfSquare_[indexOf(column, row, board_.squareColumns())];
}

bool BoardPattern::isMarkerCellDark(int marker, int column, int row) const {
  return markers_[static_cast<std::size_t>(marker)][indexOf(column, row, cells_)] != 0;
}

std::vector<BoardPattern::Rectangle> BoardPattern::darkRectangles() const {
  std::vector<Rectangle> dark;
  const double size = board_.squareSize;
  const double margin = 0.5 * (size - board_.markerSize);
  const double cell = cells_ > 0 ? board_.markerSize / cells_ : 0.0;
  for (int row = 0; row < board_.squareRows(); ++row) {
    for (int column = 0; column < board_.squareColumns(); ++column) {
      const double left = column * size;
      const double top = row * size;
      const int marker = markerAt(column, row);
      if (marker < 0) {
        if (board_.isBlack(column, row) != board_.isInverted) {
          dark.push_back({left, top, size, size});
        }
        continue;
      }
      if (board_.isInverted) { // the frame around the marker
        dark.push_back({left, top, size, margin});
        dark.push_back({left, top + size - margin, size, margin});
        dark.push_back({left, top + margin, margin, board_.markerSize});
        dark.push_back({left + size - margin, top + margin, margin, board_.markerSize});
      }
      for (int k = 0; k < cells_ * cells_; ++k) {
        const int cellColumn = k % cells_;
        const int cellRow = k / cells_;
        if (isMarkerCellDark(marker, cellColumn, cellRow) != board_.isInverted) {
          dark.push_back(
              {left + margin + cell * cellColumn, top + margin + cell * cellRow, cell, cell});
        }
      }
    }
  }
  return dark;
}

bool BoardPattern::isDark(double x, double y) const {
  const double offset = board_.kind == BoardDescription::Kind::Chessboard ? 1.0 : 0.0;
  const double u = x / board_.squareSize + offset;
  const double v = y / board_.squareSize + offset;
  const int column = static_cast<int>(std::floor(u));
  const int row = static_cast<int>(std::floor(v));
  if (column < 0 || row < 0 || column >= board_.squareColumns() || row >= board_.squareRows()) {
    return board_.isInverted;
  }
  bool dark = board_.isBlack(column, row);
  if (const int marker = markerAt(column, row); marker >= 0) {
    const double scale = board_.squareSize / board_.markerSize;
    const double inX = (u - column - 0.5) * scale + 0.5;
    const double inY = (v - row - 0.5) * scale + 0.5;
    const bool inside = inX >= 0.0 && inX < 1.0 && inY >= 0.0 && inY < 1.0;
    dark = inside &&
           isMarkerCellDark(marker, static_cast<int>(inX * cells_), static_cast<int>(inY * cells_));
  }
  return dark != board_.isInverted;
}

cv::Mat drawBoard(const BoardDescription& board, int pixelsPerSquare) {
  const BoardPattern pattern(board);
  const int margin = pixelsPerSquare / 2;
  const double offset = board.kind == BoardDescription::Kind::Chessboard ? 1.0 : 0.0;
  cv::Mat picture(board.squareRows() * pixelsPerSquare + 2 * margin,
                  board.squareColumns() * pixelsPerSquare + 2 * margin, CV_8UC1);
  for (int row = 0; row < picture.rows; ++row) {
    for (int column = 0; column < picture.cols; ++column) {
      const double x = (column + 0.5 - margin) / pixelsPerSquare - offset;
      const double y = (row + 0.5 - margin) / pixelsPerSquare - offset;
      picture.at<unsigned char>(row, column) =
          pattern.isDark(x * board.squareSize, y * board.squareSize) ? 0 : 255;
    }
  }
  return picture;
}

namespace {

/// Where the rays through the corners of all pixels meet the board's plane; NaN where they do not.
/// Within a pixel the plane is as good as linear in the image.
std::vector<Eigen::Vector2d> planeGrid(const Camera& camera, const Eigen::Isometry3d& pose) {
  Camera placed = camera;
  placed.cameraFromWorld = pose; // the board's frame as the world
  const Unprojector unprojector(placed);
  const Eigen::Vector3d& center = unprojector.center();
  std::vector<Eigen::Vector2d> grid;
  for (int row = 0; row <= camera.intrinsics.height; ++row) {
    for (int column = 0; column <= camera.intrinsics.width; ++column) {
      const auto ray = unprojector.worldDirection({column - 0.5, row - 0.5});
      const double along = ray ? -center.z() / ray->z() : -1.0;
      grid.push_back(along > 0.0 ? Eigen::Vector2d((center + along * *ray).head<2>())
                                 : Eigen::Vector2d::Constant(std::nan("")));
    }
  }
  return grid;
}

} // namespace

cv::Mat renderBoard(const BoardDescription& board, const Camera& camera,
                    const Eigen::Isometry3d& cameraFromBoard, int samples) {
  const BoardPattern pattern(board);
  const int width = camera.intrinsics.width;
  const auto grid = planeGrid(camera, cameraFromBoard);
  const Eigen::Vector2d border = Eigen::Vector2d::Constant(2.0 * board.squareSize);
  const Eigen::Vector2d lower = board.corner(0).head<2>() - border;
  const Eigen::Vector2d upper = board.corner(board.cornerCount() - 1).head<2>() + border;
  const auto level = [&](const Eigen::Vector2d& point) { // false for NaN too
    const bool page =
        (point.array() > lower.array()).all() && (point.array() < upper.array()).all();
    return !page ? kGroundLevel : pattern.isDark(point.x(), point.y()) ? kDarkLevel : kLightLevel;
  };
  cv::Mat picture(camera.intrinsics.height, width, CV_8UC1);
  for (int row = 0; row < picture.rows; ++row) {
    for (int column = 0; column < width; ++column) {
      const auto* above = &grid[indexOf(column, row, width + 1)];
      const auto* below = above + width + 1;
      double sum = 0.0;
      for (int k = 0; k < samples * samples; ++k) {
        const double u = (k % samples + 0.5) / samples;
        const double v = (k / samples + 0.5) / samples; // NOLINT: whole rows
        sum += level((1.0 - v) * ((1.0 - u) * above[0] + u * above[1]) +
                     v * ((1.0 - u) * below[0] + u * below[1]));
      }
      picture.at<unsigned char>(row, column) =
          cv::saturate_cast<unsigned char>(sum / (samples * samples));
    }
  }
  return picture;
}

} // namespace dewpoint::calibration
