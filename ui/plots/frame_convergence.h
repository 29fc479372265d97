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

/// How the particles gather within one frame: their spread at each iteration of the frame shown.
/// Hidden as long as the method makes one iteration per frame.
class FrameConvergence : public QWidget {
public:
  explicit FrameConvergence(QWidget* parent = nullptr);

  /// Boxes have a spread in pixels; all else in space.
  void setBoxes(bool boxes);
  /// Shows a frame of this run, its newest one if it is none; hides if neither that frame nor one
  /// shortly before has more than one iteration.
  void showFrame(const PlotSeries& run, std::optional<std::int64_t> frame);
  /// Iterations that are drawn.
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

/// Rows [first, last) of a frame, the last that is not after this one.
std::pair<std::size_t, std::size_t> rowsOfFrame(const PlotSeries& run, std::int64_t frame);
/// Whether that frame, or one shortly before it, has more than one iteration: a plot of them would
/// else come and go while the run goes on.
bool iteratesWithinFrames(const PlotSeries& run, std::int64_t frame);

} // namespace dewpoint::ui
