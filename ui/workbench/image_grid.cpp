// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/image_grid.h"

#include <algorithm>
#include <numeric>

namespace dewpoint::ui {

namespace {

/// By how much another grid has to cover more than the present one.
constexpr double kWorthMoving = 1.1;
constexpr double kBetter = 1.001; ///< of grids that cover the same, the one of fewer columns

/// The views of a column.
std::vector<std::size_t> viewsOf(std::size_t column, std::size_t columns, std::size_t views) {
  std::vector<std::size_t> found;
  for (std::size_t k = column; k < views; k += columns) {
    found.push_back(k);
  }
  return found;
}

} // namespace

ImageGrid imageGridOf(std::span<const double> aspects, const QSizeF& room, double title,
                      int columns) {
  ImageGrid grid;
  grid.columnCount = columns;
  grid.viewHeightShares.resize(aspects.size());
  const auto count = static_cast<std::size_t>(columns);
  for (std::size_t column = 0; column < count; ++column) {
    const auto views = viewsOf(column, count, aspects.size());
    double height = 0.0; // of the images one above the other, of a column one unit wide
    for (const std::size_t k : views) {
      height += 1.0 / aspects[k];
    }
    for (const std::size_t k : views) {
      grid.viewHeightShares[k] = 1.0 / aspects[k] / height;
    }
    const auto rows = static_cast<double>(views.size());
    // By the mean image, so that a column with a view less is not wider than the others.
    grid.columnWidthShares.push_back(rows / height);
    grid.maximumUsefulWidth += std::max(0.0, room.height() - rows * title) / height;
  }
  const double whole =
      std::accumulate(grid.columnWidthShares.begin(), grid.columnWidthShares.end(), 0.0);
  for (std::size_t column = 0; column < count; ++column) {
    grid.columnWidthShares[column] /= whole;
    const auto views = viewsOf(column, count, aspects.size());
    const double high = std::max(0.0, room.height() - static_cast<double>(views.size()) * title);
    for (const std::size_t k : views) {
      const double width = std::min(room.width() * grid.columnWidthShares[column],
                                    high * grid.viewHeightShares[k] * aspects[k]);
      grid.imageArea += width * width / aspects[k];
    }
  }
  return grid;
}

ImageGrid bestImageGrid(std::span<const double> aspects, const QSizeF& room, double title,
                        int current) {
  const int most = static_cast<int>(aspects.size());
  const bool stays = current >= 1 && current <= most;
  ImageGrid best = imageGridOf(aspects, room, title, stays ? current : 1);
  const double least = stays ? best.imageArea * kWorthMoving : 0.0;
  for (int columns = 1; columns <= most; ++columns) {
    ImageGrid other = imageGridOf(aspects, room, title, columns);
    if (other.imageArea > kBetter * best.imageArea && other.imageArea > least) {
      best = std::move(other);
    }
  }
  return best;
}

} // namespace dewpoint::ui
