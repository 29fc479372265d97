// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_axis_range.h"
#include "ui/plots/plot_series.h"
#include "ui/selection/selection.h"

#include <QObject>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace dewpoint::ui {

/// Navigation state of a stack of plots: the visible part of the axis, the current frame, the frame
/// under the pointer, and the selected range. Mouse, keys and other views change the state; the
/// stack draws it.
class PlotNavigation : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  /// Sets the series that is drawn. The series must outlive this object or be replaced.
  void setSeries(const PlotSeries* series) { series_ = series; }
  const PlotSeries* series() const { return series_; }
  void setMinIterations(int least) { range_.setMinIterations(least); }
  /// Changes the quantity on the shared axis (iterations or time). Returns false if the axis
  /// already has this quantity.
  bool setAxis(PlotAxis axis) { return range_.setAxis(axis); }
  PlotAxis axis() const { return range_.axis(); }

  /// Returns the visible part of the axis.
  std::pair<double, double> shownRange() const { return range_.shownRange(series_); }
  /// Updates the visible part of the axis after new data were added, and returns it. A part that
  /// includes the newest data moves along.
  std::pair<double, double> followNewestData() { return range_.followNewestData(series_); }
  bool showsWholeRun() const { return range_.showsWholeRun(); }
  /// Shows the whole run again.
  void showWholeRun();
  /// Shows this part of the axis.
  void showRange(double lower, double upper);
  /// Zooms in by `factor` (above 1; below 1 zooms out) around the position `about` on the axis; if
  /// it is empty, around the cursor.
  void zoom(double factor, std::optional<double> about = std::nullopt);
  /// Moves the visible part of the axis by a fraction of its width.
  void pan(double share);

  /// Sets the frame that all views show; empty: the newest frame.
  void setCurrentFrame(std::optional<std::int64_t> frame);
  std::optional<std::int64_t> currentFrame() const { return currentFrame_; }
  /// Sets the frame under the pointer, in these plots or in another view; empty if there is none.
  void setHoveredFrame(std::optional<std::int64_t> frame);
  std::optional<std::int64_t> hoveredFrame() const { return hovered_; }
  void setSelectedRange(std::optional<SelectedRange> selectedRange);
  std::optional<SelectedRange> selectedRange() const { return selectedRange_; }
  /// Sets the part of the axis over which the user is dragging. The stack zooms to this part at the
  /// end of the drag.
  void setDraggedRange(std::optional<std::pair<double, double>> part);
  std::optional<std::pair<double, double>> draggedRange() const { return dragged_; }

  /// Returns the position of a frame on the axis, or nothing before the first frame.
  std::optional<double> positionOf(const std::optional<std::int64_t>& frame) const;
  /// Returns the frame closest to a position on the axis.
  std::optional<std::int64_t> frameAt(double position) const;
  /// Returns the index of the row of the plotted series that is at the cursor, or nothing if there
  /// is none.
  std::optional<std::size_t> cursorRow() const;
  /// Returns the index of the row of the plotted series for the frame that all views show,
  /// regardless of the cursor; nothing if there is none.
  std::optional<std::size_t> shownRow() const;

Q_SIGNALS:
  /// Emitted when another part of the axis must be shown.
  void shownRangeChanged();
  /// Emitted when a line or a range has moved.
  void cursorChanged();

private:
  std::optional<std::size_t> rowOf(const std::optional<std::int64_t>& frame) const;

  const PlotSeries* series_ = nullptr;
  PlotAxisRange range_;
  std::optional<std::int64_t> currentFrame_;
  std::optional<std::int64_t> hovered_;
  std::optional<SelectedRange> selectedRange_;
  std::optional<std::pair<double, double>> dragged_;
};

} // namespace dewpoint::ui
