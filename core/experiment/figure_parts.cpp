// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/figure_parts.h"

#include <limits>

namespace dewpoint {

Status experimentStopped() {
  return failure(ErrorCode::Cancelled, "", "experiment", "stopped");
}

bool experimentGoesOn(const ExperimentOptions& options, double part) {
  return !options.progress || options.progress(part);
}

SvgSeries lineOver(const std::string& style, const std::vector<double>& values, double first,
                    double step) {
  SvgSeries series;
  series.style = style;
  for (std::size_t k = 0; k < values.size(); ++k) {
    series.line.push_back({first + step * static_cast<double>(k), values[k]});
  }
  return series;
}

SvgSeries pointsOf(const std::string& style, const Eigen::ArrayXXd& rows, Eigen::Index across,
                    Eigen::Index up, double area) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  SvgSeries series;
  series.style = style;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    series.line.push_back({rows(i, across), rows(i, up)});
    series.areas.push_back(area);
    series.line.push_back({rows(i, across), kGap});
    series.areas.push_back(0.0);
  }
  return series;
}

} // namespace dewpoint
