// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_axis_range.h"

#include <algorithm>

namespace dewpoint::ui {

bool PlotAxisRange::setAxis(PlotAxis axis) {
  if (axis == axis_) {
    return false;
  }
  axis_ = axis;
  showWholeRun();
  return true;
}

PlotAxisRange::Range PlotAxisRange::fullRange(const PlotSeries* series) const {
  const double least = axis_ == PlotAxis::Time ? 2.0 : minIterations_;
  if (series == nullptr || series->size() == 0) {
    return {0.0, least};
  }
  const double first = series->axisPosition(0, axis_);
  return {first, std::max(series->axisPosition(series->size() - 1, axis_), first + least)};
}

PlotAxisRange::Range PlotAxisRange::shownRange(const PlotSeries* series) const {
  if (!shownRange_ || series == nullptr || series->size() == 0) {
    return fullRange(series);
  }
  const double last = series->axisPosition(series->size() - 1, axis_);
  const double moved = following_ ? std::max(0.0, last - shownRange_->second) : 0.0;
  return {shownRange_->first + moved, shownRange_->second + moved};
}

PlotAxisRange::Range PlotAxisRange::followNewestData(const PlotSeries* series) {
  if (shownRange_ && series != nullptr && series->size() > 0) {
    const double newest = series->axisPosition(series->size() - 1, axis_);
    if (newest < newest_ && newest < shownRange_->first) {
      showWholeRun();
    }
    newest_ = newest;
  }
  const Range now = shownRange(series);
  if (shownRange_) {
    shownRange_ = now;
  }
  return now;
}

void PlotAxisRange::showWholeRun() {
  shownRange_.reset();
  following_ = false;
}

void PlotAxisRange::showRange(const PlotSeries* series, double lower, double upper) {
  if (series == nullptr || series->size() == 0) {
    return;
  }
  const auto [first, end] = fullRange(series);
  const double last = series->axisPosition(series->size() - 1, axis_);
  const double width = std::max(axis_ == PlotAxis::Time ? 0.1 : 4.0, upper - lower);
  if (width >= end - first) {
    showWholeRun();
    return;
  }
  // Never beyond the run; a part that reaches the newest frame moves along with it.
  const double from = std::clamp(lower, first, end - width);
  following_ = from + width >= last;
  shownRange_ = Range(from, from + width);
  newest_ = last;
}

} // namespace dewpoint::ui
