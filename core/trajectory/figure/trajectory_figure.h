// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/export/export_table.h"

#include <Eigen/Core>

#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace dewpoint::trajectory {

/// Range of values on an axis.
struct AxisRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  /// Extends the range to contain `value`.
  void include(double value);
  double size() const { return high - low; }
  /// Returns the range widened by 5 % at each end; its size is never zero. Returns 0 to 1 if no
  /// value was included.
  AxisRange padded() const;
};

/// Returns the spacing of grid lines over a range of this size: 1, 2 or 5 times a power of ten, for
/// about five lines.
double gridLineSpacing(double size);

/// Returns the values of the grid lines in a range. They are multiples of a round spacing
/// (gridLineSpacing()) that gives about five lines.
std::vector<double> gridLineValues(const AxisRange& range);

/// Returns both ranges, one of them widened about its center, so that both axes have the same scale
/// in a rectangle of this width and height.
std::pair<AxisRange, AxisRange>
withEqualScale(const AxisRange& horizontal, const AxisRange& vertical, double width, double height);

/// Part of the curve of one target, between two gaps in its rows. The points are (horizontal,
/// vertical), in the units of the axes of the panel.
struct FigureCurve {
  std::size_t target = 0;
  std::vector<Eigen::Vector2d> path;
  /// Closed outline of the band of two standard deviations around the path. Empty if the curve has
  /// no band.
  std::vector<Eigen::Vector2d> uncertaintyBand;
};

/// A rectangular plot with two axes. Axis numbers 0 to 2 mean world axes x to z, and -1 means time.
struct FigurePanel {
  int horizontalAxis = -1;
  int verticalAxis = 0;
  AxisRange horizontalRange;
  AxisRange verticalRange;
  std::vector<FigureCurve> curves; ///< curves of the plot, ordered by target
};

/// Contents of a trajectory's figure, in the unit and along the axes of the table.
struct TrajectoryFigure {
  /// Plots of x, y and z over time, with bands of two standard deviations.
  std::array<FigurePanel, 3> panelsOverTime;
  /// Path seen from above, in a square with the same scale on both axes.
  FigurePanel topViewPanel;
};
/// Computes the figure of a table.
TrajectoryFigure computeTrajectoryFigure(const ExportTable& table);

} // namespace dewpoint::trajectory
