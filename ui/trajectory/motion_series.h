// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/motion.h"
#include "ui/plots/plot_series.h"

#include <string>
#include <vector>

namespace dewpoint::ui {

/// Speed (m/s) and height (m) of one target over time, for use in plots.
class MotionSeries {
public:
  static constexpr std::size_t kSpeedColumn = 0; ///< column of the speed in the series
  static constexpr std::size_t kHeightColumn = 1;
  static constexpr std::size_t kColumnCount = 2;

  MotionSeries() { series_.reset(kColumnCount); }

  const PlotSeries& series() const { return series_; }
  /// Returns the target name, or an empty string while nothing has been tracked.
  const std::string& target() const { return target_; }
  /// Selects a target, and fills the series with its speed and height from all rows of the log.
  void setTarget(const std::string& target, const std::vector<MotionLog::Row>& rows);
  /// Updates the series after the log rows from `firstChangedRow` onward have changed.
  void update(const std::vector<MotionLog::Row>& rows, std::size_t firstChangedRow);
  void clear();

private:
  void breakLineBefore(const TrajectorySample& sample);

  PlotSeries series_;
  std::string target_;
};

/// Returns a target's path in rows [first, last) of a log, in meters. There is one list of
/// positions per uninterrupted part, with at most `most` positions in total.
std::vector<std::vector<Eigen::Vector3d>> pathSegments(const std::vector<MotionLog::Row>& rows,
                                                       std::size_t first, std::size_t last,
                                                       const std::string& target, std::size_t most);

} // namespace dewpoint::ui
