// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Where a value lies on one axis of a plot.
struct SvgAxis {
  std::string label;
  double low = 0.0;
  double high = 1.0;
  bool logarithmic = false;
};

struct SvgPoint {
  double x = 0.0;
  double y = 0.0; ///< NaN: the line is interrupted here
};

/// A line with, if wanted, a band around it or a disk on each point.
struct SvgSeries {
  std::string style; ///< CSS class that gives the color ("m0" to "m8")
  std::vector<SvgPoint> line;
  std::vector<double> bandLow;  ///< at the line's points; empty for none
  std::vector<double> bandHigh; ///< at the line's points; empty for none
  std::vector<double> areas;    ///< of disks on the line's points, square pixels; empty for none
};

struct Plot {
  std::string title; ///< for screen readers
  SvgAxis x;
  SvgAxis y;
  bool diagonal = false; ///< a guide from corner to corner
  std::vector<SvgSeries> series;
};

/// The plot as an SVG element to stand in HTML: its colors are the page's CSS variables. Values
/// outside the axes are moved to the border.
std::string svgOf(const Plot& plot);

/// Positions of the ticks of an axis, ascending: at most about six.
std::vector<double> axisMarks(const SvgAxis& axis);

} // namespace dewpoint::experiment
