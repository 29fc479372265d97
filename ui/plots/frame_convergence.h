// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_series.h"

#include <QWidget>

#include <cstdint>
#include <optional>
#include <utility>

class QLabel;

namespace dewpoint::ui {

class PlotStack;

/// Plot of convergence within one frame: the spread of the particles at each iteration of the frame
/// shown. Hidden while the method makes one iteration per frame.
class FrameConvergence : public QWidget {
public:
  explicit FrameConvergence(QWidget* parent = nullptr);

  /// Sets whether the target is a bounding box, whose spread is in pixels; otherwise the spread is
  /// in meters.
  void setBoxes(bool boxes);
  /// Shows a frame of this run, or the newest frame if `frame` is empty. Hides the plot if neither
  /// this frame nor one shortly before it has more than one iteration.
  void showFrame(const PlotSeries& run, std::optional<std::int64_t> frame);
  /// Number of iterations drawn.
  std::size_t iterations() const { return series_.size(); }
  PlotStack& stack() { return *stack_; }

private:
  void declarePlot();
  void updateTitle();

  QLabel* title_;
  PlotStack* stack_;
  PlotSeries series_; ///< one row per iteration, counted from 1 in the frame
  bool boxes_ = false;
  std::int64_t frame_ = -1;
};

/// Returns the rows [first, last) of a frame, or of the last frame before it.
std::pair<std::size_t, std::size_t> rowsOfFrame(const PlotSeries& run, std::int64_t frame);
/// Whether this frame, or one shortly before it, has more than one iteration. Looking back keeps
/// the plot from flickering while the run continues.
bool iteratesWithinFrames(const PlotSeries& run, std::int64_t frame);

} // namespace dewpoint::ui
