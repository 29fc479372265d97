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

/// Where a stack of plots is along its axis: the part that is shown, the current frame, the one the
/// pointer is on, and the range. Mouse, keys and other views change it; the stack draws it.
class PlotNavigation : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  /// What is drawn; must outlive this, or be replaced.
  void setSeries(const PlotSeries* series) { series_ = series; }
  const PlotSeries* series() const { return series_; }
  void setLeastIterations(int least) { range_.setLeastIterations(least); }
  /// False when it is the same.
  bool setAxis(PlotAxis axis) { return range_.setAxis(axis); }
  PlotAxis axis() const { return range_.axis(); }

  /// The part of the axis that is shown.
  std::pair<double, double> shownRange() const { return range_.shown(series_); }
  /// The same, gone along with the newest.
  std::pair<double, double> advance() { return range_.advance(series_); }
  bool showsAll() const { return range_.showsAll(); }
  /// The whole run again.
  void showAll();
  /// This part of the axis.
  void showPart(double lower, double upper);
  /// Nearer by `factor` (above 1) about a position on the axis, or about the cursor.
  void zoom(double factor, std::optional<double> about = std::nullopt);
  /// By a share of the width shown.
  void pan(double share);

  /// The frame all views show; nothing: the newest.
  void setCurrentFrame(std::optional<std::int64_t> frame);
  std::optional<std::int64_t> currentFrame() const { return currentFrame_; }
  /// The frame the pointer is on, here or in another view; nothing: nowhere.
  void setHovered(std::optional<std::int64_t> frame);
  std::optional<std::int64_t> hovered() const { return hovered_; }
  void setSelectedRange(std::optional<SelectedRange> selectedRange);
  std::optional<SelectedRange> selectedRange() const { return selectedRange_; }
  /// The part that is being dragged over, to be zoomed to.
  void setDragged(std::optional<std::pair<double, double>> part);
  std::optional<std::pair<double, double>> dragged() const { return dragged_; }

  /// Position of a frame on the axis; nothing before the first.
  std::optional<double> positionOf(const std::optional<std::int64_t>& frame) const;
  /// The frame nearest to a position on the axis.
  std::optional<std::int64_t> frameAt(double position) const;
  /// Row of the series that the cursor is on.
  std::optional<std::size_t> cursorRow() const;

Q_SIGNALS:
  /// Another part of the axis is to be shown.
  void partChanged();
  /// A line or a range is elsewhere.
  void cursorChanged();

private:
  const PlotSeries* series_ = nullptr;
  PlotAxisRange range_;
  std::optional<std::int64_t> currentFrame_;
  std::optional<std::int64_t> hovered_;
  std::optional<SelectedRange> selectedRange_;
  std::optional<std::pair<double, double>> dragged_;
};

} // namespace dewpoint::ui
