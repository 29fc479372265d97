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

/// Plot of convergence within one frame: the particle spread at each iteration of the frame shown.
/// Hidden if the method runs one iteration per frame.
class FrameConvergence : public QWidget {
public:
  explicit FrameConvergence(QWidget* parent = nullptr);

  /// Sets whether the target is a bounding box, whose spread is in pixels. Otherwise the spread is
  /// in meters.
  void setTargetIsBox(bool boxes);
  /// Shows the iterations of a frame of this run, or of the newest frame if `frame` is empty. Hides
  /// the plot unless this frame, or a frame shortly before, has more than one iteration.
  void showFrame(const PlotSeries& run, std::optional<std::int64_t> frame);
  /// Returns the number of iterations drawn.
  std::size_t iterationCount() const { return series_.size(); }
  PlotStack& stack() { return *stack_; }

private:
  void declarePlot();
  void updateTitle();

  QLabel* title_;
  PlotStack* stack_;
  PlotSeries series_; ///< one row per iteration, numbered from 1 within the frame
  bool boxes_ = false;
  std::int64_t frame_ = -1;
};

/// Returns the rows [first, last) of a frame in a series; if the frame has no rows, the rows of the
/// last earlier frame.
std::pair<std::size_t, std::size_t> rowsOfFrame(const PlotSeries& run, std::int64_t frame);
/// Returns whether this frame, or a frame shortly before, has more than one iteration. Earlier
/// frames are included so that the plot does not flicker while the run continues.
bool hasSeveralIterationsPerFrame(const PlotSeries& run, std::int64_t frame);

} // namespace dewpoint::ui
