// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/report/figure_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::experiment {

Status stoppedExperimentError() {
  return failure(ErrorCode::Canceled, "", "experiment", "stopped");
}

bool reportProgress(const ExperimentOptions& options, double part) {
  return !options.progress || options.progress(part);
}

SvgSeries lineSeries(const std::string& style, const std::vector<double>& values, double first,
                     double step) {
  SvgSeries series;
  series.style = style;
  for (std::size_t k = 0; k < values.size(); ++k) {
    series.points.push_back({first + step * static_cast<double>(k), values[k]});
  }
  return series;
}

void setCommonAxes(std::initializer_list<Plot*> plots, double least) {
  constexpr double kProportion = 1.6; // of a plot's width to its height
  constexpr double kMargin = 0.05;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  SvgPoint low{kInfinity, kInfinity};
  SvgPoint high{-kInfinity, -kInfinity};
  for (const Plot* plot : plots) {
    for (const SvgSeries& series : plot->series) {
      for (const SvgPoint& point : series.points) {
        if (std::isfinite(point.x) && std::isfinite(point.y)) {
          low = {std::min(low.x, point.x), std::min(low.y, point.y)};
          high = {std::max(high.x, point.x), std::max(high.y, point.y)};
        }
      }
    }
  }
  const double up =
      (1.0 + 2.0 * kMargin) * std::max({least, high.y - low.y, (high.x - low.x) / kProportion});
  const SvgPoint middle{0.5 * (low.x + high.x), 0.5 * (low.y + high.y)};
  for (Plot* plot : plots) {
    plot->x.low = middle.x - 0.5 * kProportion * up;
    plot->x.high = middle.x + 0.5 * kProportion * up;
    plot->y.low = middle.y - 0.5 * up;
    plot->y.high = middle.y + 0.5 * up;
  }
}

SvgSeries pointSeries(const std::string& style, const Eigen::ArrayXXd& rows, Eigen::Index across,
                      Eigen::Index up, double area) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  SvgSeries series;
  series.style = style;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    series.points.push_back({rows(i, across), rows(i, up)});
    series.diskAreas.push_back(area);
    series.points.push_back({rows(i, across), kGap});
    series.diskAreas.push_back(0.0);
  }
  return series;
}

} // namespace dewpoint::experiment
