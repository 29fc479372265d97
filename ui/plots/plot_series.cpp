// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_series.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::ui {

namespace {

/// The least and the greatest value of one part of the axis, in the order they came.
class Part {
public:
  void add(double key, double value) {
    if (!any_ || value < least_.value) {
      least_ = {key, value};
    }
    if (!any_ || value > most_.value) {
      most_ = {key, value};
    }
    any_ = true;
  }
  void writeTo(PlotSeries::CurvePoints& line) {
    if (any_) {
      const bool rising = least_.key <= most_.key;
      put(line, rising ? least_ : most_);
      if (least_.value < most_.value) {
        put(line, rising ? most_ : least_);
      }
    }
    any_ = false;
  }

private:
  struct Point {
    double key = 0.0;
    double value = 0.0;
  };
  static void put(PlotSeries::CurvePoints& line, const Point& point) {
    line.axisPositions.push_back(point.key);
    line.values.push_back(point.value);
  }

  Point least_;
  Point most_;
  bool any_ = false;
};

} // namespace

void PlotSeries::reset(std::size_t columns) {
  columns_ = columns;
  rows_.clear();
  values_.clear();
  known_.assign(columns, false);
}

void PlotSeries::append(const Row& row, std::span<const float> values) {
  rows_.push_back(row);
  values_.insert(values_.end(), values.begin(), values.end());
  values_.resize(rows_.size() * columns_, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t column = 0; column < columns_; ++column) {
    known_[column] = known_[column] || std::isfinite(value(rows_.size() - 1, column));
  }
  if (rows_.size() > kMaxRows) {
    thin();
  }
}

void PlotSeries::removeFrom(std::int64_t frame) {
  while (!rows_.empty() && rows_.back().frame >= frame) {
    rows_.pop_back();
  }
  values_.resize(rows_.size() * columns_);
}

void PlotSeries::thin() {
  const std::size_t half = rows_.size() / 2;
  std::size_t kept = 0;
  for (std::size_t index = 0; index < rows_.size(); ++index) {
    if (index < half && index % 2 == 1) {
      continue;
    }
    rows_[kept] = rows_[index];
    std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(index * columns_), columns_,
                values_.begin() + static_cast<std::ptrdiff_t>(kept * columns_));
    ++kept;
  }
  rows_.resize(kept);
  values_.resize(kept * columns_);
}

double PlotSeries::axisPosition(std::size_t index, PlotAxis axis) const {
  return axis == PlotAxis::Time ? rows_[index].seconds
                                : static_cast<double>(rows_[index].iteration);
}

bool PlotSeries::isRowDrawn(std::size_t index, PlotAxis axis) const {
  return axis == PlotAxis::Iterations || index + 1 == rows_.size() ||
         rows_[index + 1].frame != rows_[index].frame;
}

std::pair<std::size_t, std::size_t> PlotSeries::rowsWithin(PlotAxis axis, double lower,
                                                           double upper) const {
  const auto keyOf = [axis](const Row& row) {
    return axis == PlotAxis::Time ? row.seconds : static_cast<double>(row.iteration);
  };
  const auto first = std::ranges::lower_bound(rows_, lower, {}, keyOf);
  const auto last = std::ranges::upper_bound(rows_, upper, {}, keyOf);
  const auto place = [this](auto found) {
    return static_cast<std::size_t>(std::distance(rows_.begin(), found));
  };
  return {place(first), std::max(place(first), place(last))};
}

std::optional<std::size_t> PlotSeries::nearestRow(PlotAxis axis, double wanted) const {
  if (rows_.empty()) {
    return std::nullopt;
  }
  std::size_t found = std::min(rowsWithin(axis, wanted, wanted).first, rows_.size() - 1);
  if (found > 0 && wanted - axisPosition(found - 1, axis) < axisPosition(found, axis) - wanted) {
    --found;
  }
  while (!isRowDrawn(found, axis)) {
    ++found;
  }
  return found;
}

std::optional<std::size_t> PlotSeries::rowAtFrame(std::int64_t frame) const {
  const auto after = std::ranges::upper_bound(rows_, frame, {}, &Row::frame);
  if (after == rows_.begin()) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(std::distance(rows_.begin(), after)) - 1;
}

PlotSeries::CurvePoints PlotSeries::curvePoints(std::size_t column, PlotAxis axis, double lower,
                                                double upper, int pixels,
                                                const std::optional<ColumnOffset>& offset) const {
  CurvePoints line;
  auto [first, last] = rowsWithin(axis, lower, upper);
  first -= first > 0 ? 1 : 0;
  last += last < rows_.size() ? 1 : 0;
  const bool all = last - first <= 2 * static_cast<std::size_t>(pixels);
  const double width = (upper - lower) / pixels;
  double part = -std::numeric_limits<double>::infinity();
  Part extremes;
  bool gap = false;
  for (std::size_t index = first; index < last; ++index) {
    if (!isRowDrawn(index, axis)) {
      continue;
    }
    const double place = axisPosition(index, axis);
    const double drawn =
        value(index, column) + (offset ? offset->columnFactor * value(index, offset->column) : 0.0);
    const double its = all ? place : std::floor((place - lower) / width);
    if (its != part || !std::isfinite(drawn)) {
      extremes.writeTo(line);
      part = its;
    }
    if (std::isfinite(drawn)) {
      extremes.add(place, drawn);
      gap = false;
    } else if (!gap) {
      line.axisPositions.push_back(place);
      line.values.push_back(std::numeric_limits<double>::quiet_NaN());
      gap = true;
    }
  }
  extremes.writeTo(line);
  return line;
}

} // namespace dewpoint::ui
