// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_series.h"

#include <optional>
#include <utility>

namespace dewpoint::ui {

/// The part of the shared axis that plots show: the whole run, or a chosen part, which moves along
/// with the newest once it reaches it.
class PlotAxisRange {
public:
  using Range = std::pair<double, double>; ///< lower and upper end, on the axis

  PlotAxis axis() const { return axis_; }
  /// A run of fewer iterations than that grows into the axis.
  void setLeastIterations(double least) { leastIterations_ = least; }
  /// Along another axis, the whole run; false when it is the same.
  bool setAxis(PlotAxis axis);
  /// The whole run; a run that has just begun grows into it. Null: nothing was tracked.
  Range whole(const PlotSeries* series) const;
  Range shown(const PlotSeries* series) const;
  /// Goes along with the newest, and returns what is shown now: the whole run if it has gone back
  /// to before the part that was shown.
  Range advance(const PlotSeries* series);
  bool showsAll() const { return !part_.has_value(); }
  void showAll();
  /// This part, never beyond the run, nor too small to read.
  void show(const PlotSeries* series, double lower, double upper);

private:
  PlotAxis axis_ = PlotAxis::Iterations;
  double leastIterations_ = 60.0;
  std::optional<Range> part_; ///< nothing: all
  bool following_ = false;    ///< the part moves along with the newest
  double newest_ = 0.0;       ///< position of the newest, when the part was shown last
};

} // namespace dewpoint::ui
