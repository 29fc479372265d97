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

/// What the plots are drawn over.
enum class PlotAxis { Iterations, Time };

/// Rows of numbers that several curves are drawn from: one per filter iteration (or frame), in the
/// order they happened. Bounded: beyond kMostRows every second one of the older half goes, again
/// and again, so that the newest are there in full. Unknown numbers are not a number.
class PlotSeries {
public:
  static constexpr std::size_t kMostRows = 40000;
  struct Row {
    std::int64_t iteration = 0;
    std::int64_t frame = 0;
    double time = 0.0; ///< seconds
  };
  /// A curve as it is drawn; keys ascend.
  struct Line {
    std::vector<double> keys;
    std::vector<double> values;
  };

  /// Forgets all rows; those to come have this many values.
  void reset(std::size_t columns);
  void append(const Row& row, std::span<const float> values);
  /// Forgets this frame's rows and all later ones.
  void removeFrom(std::int64_t frame);

  std::size_t size() const { return rows_.size(); }
  std::size_t columns() const { return columns_; }
  const Row& row(std::size_t index) const { return rows_[index]; }
  double value(std::size_t index, std::size_t column) const {
    return static_cast<double>(values_[index * columns_ + column]);
  }
  /// Whether any row has a number in this column.
  bool isKnown(std::size_t column) const { return known_[column]; }
  /// Position of a row on the axis.
  double key(std::size_t index, PlotAxis axis) const;
  /// The row nearest to a position on the axis; nothing when there are no rows. Over time a frame
  /// is represented by its last iteration.
  std::optional<std::size_t> nearest(PlotAxis axis, double key) const;
  /// The last row of this frame, or of the last one before it.
  std::optional<std::size_t> atFrame(std::int64_t frame) const;
  /// Rows [first, last) whose keys are within [lower, upper].
  std::pair<std::size_t, std::size_t> within(PlotAxis axis, double lower, double upper) const;
  /// Over time only a frame's last iteration is drawn.
  bool isDrawn(std::size_t index, PlotAxis axis) const;
  /// Added to a curve's values: so many times another column.
  struct Offset {
    std::size_t column = 0;
    double factor = 0.0;
  };
  /// The column within [lower, upper] and one row beyond, in at most about two points for each of
  /// `pixels` parts: the least and the greatest value of each.
  Line line(std::size_t column, PlotAxis axis, double lower, double upper, int pixels,
            const std::optional<Offset>& offset = std::nullopt) const;

private:
  void thin();

  std::size_t columns_ = 0;
  std::vector<Row> rows_;
  std::vector<float> values_;
  std::vector<bool> known_;
};

} // namespace dewpoint::ui
