// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Range and scale of one axis of a plot.
struct SvgAxis {
  std::string label;
  double low = 0.0;
  double high = 1.0;
  bool isLogarithmic = false;
};

/// Point of a line, in the units of the axes.
struct SvgPoint {
  double x = 0.0;
  double y = 0.0; ///< vertical coordinate; if NaN, the line is interrupted at this point
};

/// Line, optionally with a band around it or a disk on each point.
struct SvgSeries {
  std::string style; ///< CSS class for the color ("m0" to "m8")
  std::vector<SvgPoint> points;
  /// Lower border of the band at each point of the line; empty: no band.
  std::vector<double> bandLow;
  /// Upper border of the band at each point of the line; empty: no band.
  std::vector<double> bandHigh;
  std::vector<double> diskAreas; ///< area of the disk on each point, square pixels; empty: no disks
};

/// Plot of lines and points, with its axes.
struct Plot {
  std::string title; ///< description for screen readers; not visible in the plot
  SvgAxis x;
  SvgAxis y;
  bool drawsDiagonal = false; ///< true: a diagonal line is drawn from corner to corner
  std::vector<SvgSeries> series;
};

/// Renders the plot as an SVG element for an HTML page, with the page's CSS variables as colors.
/// Values outside the axis ranges are moved to the border.
std::string renderSvg(const Plot& plot);

/// Returns the tick positions of an axis in ascending order. There are at most about six.
std::vector<double> axisTicks(const SvgAxis& axis);

} // namespace dewpoint::experiment
