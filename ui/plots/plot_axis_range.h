// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_series.h"

#include <optional>
#include <utility>

namespace dewpoint::ui {

/// Range of the axis shared by all plots: the whole run, or a part of it. If a part includes the
/// newest data, it moves along as the run continues.
class PlotAxisRange {
public:
  using Range = std::pair<double, double>; ///< lower and upper end, in units of the axis

  PlotAxis axis() const { return axis_; }
  /// Sets the minimum length of the axis in iterations. A shorter run fills the axis gradually.
  void setMinIterations(double least) { minIterations_ = least; }
  /// Sets the quantity on the axis (iterations or time) and shows the whole run. Returns false if
  /// the axis already has this quantity.
  bool setAxis(PlotAxis axis);
  /// Returns the axis range of the whole run, extended to the minimum length. `series` is null if
  /// nothing was tracked.
  Range fullRange(const PlotSeries* series) const;
  Range shownRange(const PlotSeries* series) const;
  /// Updates the range after new data were added, and returns the range to show. A range that
  /// includes the newest data moves along. Shows the whole run again if the run went back to before
  /// the range shown.
  Range followNewestData(const PlotSeries* series);
  bool showsWholeRun() const { return !shownRange_.has_value(); }
  void showWholeRun();
  /// Shows the range from `lower` to `upper`, limited to the run and extended to a readable minimum
  /// length if necessary.
  void showRange(const PlotSeries* series, double lower, double upper);

private:
  PlotAxis axis_ = PlotAxis::Iterations;
  double minIterations_ = 60.0;
  std::optional<Range> shownRange_; ///< range shown; empty for the whole run
  bool following_ = false;          ///< the range moves along with the newest data
  double newest_ = 0.0;             ///< newest position on the axis when the range was last shown
};

} // namespace dewpoint::ui
