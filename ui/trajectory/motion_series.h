// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/motion.h"
#include "ui/plots/plot_series.h"

#include <string>
#include <vector>

namespace dewpoint::ui {

/// Speed (m/s) and height (m) of one target over time, as input for plots.
class MotionSeries {
public:
  static constexpr std::size_t kSpeed = 0; ///< column indices
  static constexpr std::size_t kHeight = 1;
  static constexpr std::size_t kColumns = 2;

  MotionSeries() { series_.reset(kColumns); }

  const PlotSeries& series() const { return series_; }
  /// Name of the target; empty while nothing was tracked.
  const std::string& target() const { return target_; }
  /// Selects a target and fills the series from all rows of the log.
  void setTarget(const std::string& target, const std::vector<MotionLog::Row>& rows);
  /// Updates the series after the rows of the log from `firstChanged` on have changed.
  void update(const std::vector<MotionLog::Row>& rows, std::size_t firstChanged);
  void clear();

private:
  void breakLineBefore(const TrajectorySample& sample);

  PlotSeries series_;
  std::string target_;
};

/// Returns the path of a target in rows [first, last) of a log, in meters: one stroke per
/// uninterrupted part, with at most `most` positions in total.
std::vector<std::vector<Eigen::Vector3d>> strokesOf(const std::vector<MotionLog::Row>& rows,
                                                    std::size_t first, std::size_t last,
                                                    const std::string& target, std::size_t most);

} // namespace dewpoint::ui
