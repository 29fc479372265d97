// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/export/export_table.h"

#include <Eigen/Core>

#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace dewpoint::trajectory {

/// A stretch of an axis.
struct AxisRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value);
  double size() const { return high - low; }
  /// A twentieth wider at both ends, and never without size; 0 to 1 when nothing was included.
  AxisRange padded() const;
};

/// Distance of the lines of a grid over a stretch of this size: 1, 2 or 5 times a power of ten,
/// about five of them.
double gridStep(double size);

/// Where the lines of a grid lie within a range, at multiples of gridStep().
std::vector<double> gridLines(const AxisRange& range);

/// Two ranges widened about their middles, so that both have the same scale in a frame of this
/// width and height.
std::pair<AxisRange, AxisRange>
withEqualScale(const AxisRange& horizontal, const AxisRange& vertical, double width, double height);

/// Rows of a target without a gap, as points (horizontal, vertical) of a panel.
struct FigureCurve {
  std::size_t target = 0;
  std::vector<Eigen::Vector2d> path;
  /// The outline of the band around it, closed; may be empty.
  std::vector<Eigen::Vector2d> band;
};

/// A frame with two axes; which axis of the world runs along each, -1: time.
struct FigurePanel {
  int horizontalAxis = -1;
  int verticalAxis = 0;
  AxisRange horizontal;
  AxisRange vertical;
  std::vector<FigureCurve> curves; ///< of one target after the other
};

/// What a figure of a trajectory shows, in the unit and along the axes of the table.
struct TrajectoryFigure {
  std::array<FigurePanel, 3> overTime; ///< x, y and z, with bands of two standard deviations
  /// The path on the floor; in the same scale in a square frame.
  FigurePanel fromAbove;
};
TrajectoryFigure trajectoryFigure(const ExportTable& table);

} // namespace dewpoint::trajectory
