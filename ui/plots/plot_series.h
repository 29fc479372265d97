// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace dewpoint::ui {

/// Quantity on the x axis of a plot.
enum class PlotAxis { Iterations, Time };

/// Rows of numbers from which several curves are drawn: one row per filter iteration (or frame), in
/// chronological order. The size is limited: above kMaxRows, every second row of the older half is
/// removed, repeatedly, so that the newest rows are complete. Unknown values are NaN.
class PlotSeries {
public:
  static constexpr std::size_t kMaxRows = 40000;
  struct Row {
    std::int64_t iteration = 0;
    std::int64_t frame = 0;
    double seconds = 0.0; ///< time of the frame
  };
  /// Points of a drawn curve, in ascending order of their positions on the axis.
  struct CurvePoints {
    std::vector<double> axisPositions;
    std::vector<double> values;
  };

  /// Removes all rows, and sets the number of values per row.
  void reset(std::size_t columns);
  void append(const Row& row, std::span<const float> values);
  /// Removes the rows of this frame and of all later frames.
  void removeFrom(std::int64_t frame);

  std::size_t size() const { return rows_.size(); }
  std::size_t columnCount() const { return columns_; }
  const Row& row(std::size_t index) const { return rows_[index]; }
  double value(std::size_t index, std::size_t column) const {
    return static_cast<double>(values_[index * columns_ + column]);
  }
  /// Returns whether any row has a number in this column.
  bool hasValuesInColumn(std::size_t column) const { return known_[column]; }
  /// Returns the position of a row on the axis.
  double axisPosition(std::size_t index, PlotAxis axis) const;
  /// Returns the index of the row closest to a position on the axis; nothing if there are no rows.
  /// On the time axis, the last iteration of a frame represents the frame.
  std::optional<std::size_t> nearestRow(PlotAxis axis, double key) const;
  /// Returns the index of the last row of this frame or, if it has none, of the closest earlier
  /// frame.
  std::optional<std::size_t> rowAtFrame(std::int64_t frame) const;
  /// Returns the indices [first, last) of the rows whose axis positions are within [lower, upper].
  std::pair<std::size_t, std::size_t> rowsWithin(PlotAxis axis, double lower, double upper) const;
  /// Returns whether a row is drawn. On the time axis, only the last iteration of a frame is drawn.
  bool isRowDrawn(std::size_t index, PlotAxis axis) const;
  /// Offset to add to the values of a curve: the values of another column, times `columnFactor`.
  struct ColumnOffset {
    std::size_t column = 0;
    double columnFactor = 0.0;
  };
  /// Returns the points of a curve: the values of a column within the axis range [lower, upper],
  /// plus one row beyond each end. If there are many, they are reduced to about two points for each
  /// of `pixels` intervals, the smallest and the largest value.
  CurvePoints curvePoints(std::size_t column, PlotAxis axis, double lower, double upper, int pixels,
                          const std::optional<ColumnOffset>& offset = std::nullopt) const;

private:
  void thin();

  std::size_t columns_ = 0;
  std::vector<Row> rows_;
  std::vector<float> values_;
  std::vector<bool> known_;
};

} // namespace dewpoint::ui
