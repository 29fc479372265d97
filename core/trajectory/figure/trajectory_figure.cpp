// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/figure/trajectory_figure.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace dewpoint::trajectory {
namespace {

constexpr double kBandSigmas = 2.0;

double sigmaOf(const ExportCell& cell, int axis) {
  return cell.covariance ? std::sqrt(std::max(0.0, (*cell.covariance)(axis, axis))) : 0.0;
}

/// Calls `stretch(begin, end)` for each run of rows without a gap.
template <class Stretch> void forStretches(const std::vector<ExportCell>& cells, Stretch stretch) {
  for (std::size_t begin = 0; begin < cells.size();) {
    std::size_t end = begin;
    while (end < cells.size() && cells[end].hasPosition) {
      ++end;
    }
    if (end > begin) {
      stretch(begin, end);
    }
    begin = end + 1;
  }
}

AxisRange rangeOf(const ExportTable& table, int axis) {
  AxisRange range;
  for (const auto& column : table.cells) {
    for (const ExportCell& cell : column) {
      if (cell.hasPosition) {
        range.include(cell.position[axis]);
      }
    }
  }
  return range.padded();
}

AxisRange timesOf(const ExportTable& table) {
  AxisRange range;
  for (const double time : table.times) {
    range.include(time);
  }
  return range.padded();
}

FigureCurve curveOverTime(const ExportTable& table, std::size_t target, int axis, std::size_t begin,
                          std::size_t end) {
  const auto& cells = table.cells[target];
  FigureCurve curve{target, {}, {}};
  std::vector<Eigen::Vector2d> lower;
  for (std::size_t row = begin; row < end; ++row) {
    const double value = cells[row].position[axis];
    const double off = kBandSigmas * sigmaOf(cells[row], axis);
    curve.path.emplace_back(table.times[row], value);
    curve.uncertaintyBand.emplace_back(table.times[row], value + off);
    lower.emplace_back(table.times[row], value - off);
  }
  curve.uncertaintyBand.insert(curve.uncertaintyBand.end(), lower.rbegin(), lower.rend());
  return curve;
}

FigurePanel overTime(const ExportTable& table, int axis) {
  FigurePanel panel{-1, axis, timesOf(table), rangeOf(table, axis), {}};
  for (std::size_t target = 0; target < table.targets.size(); ++target) {
    forStretches(table.cells[target], [&](std::size_t begin, std::size_t end) {
      panel.curves.push_back(curveOverTime(table, target, axis, begin, end));
    });
  }
  return panel;
}

FigurePanel fromAbove(const ExportTable& table) {
  FigurePanel panel; // of the two axes that lie on the floor
  panel.horizontalAxis = table.axes == WorldAxes::ZUp ? 0 : 2;
  panel.verticalAxis = table.axes == WorldAxes::ZUp ? 1 : 0;
  std::tie(panel.horizontalRange, panel.verticalRange) = withEqualScale(
      rangeOf(table, panel.horizontalAxis), rangeOf(table, panel.verticalAxis), 1.0, 1.0);
  for (std::size_t target = 0; target < table.targets.size(); ++target) {
    const auto& cells = table.cells[target];
    forStretches(cells, [&](std::size_t begin, std::size_t end) {
      FigureCurve& curve = panel.curves.emplace_back(FigureCurve{target, {}, {}});
      for (std::size_t row = begin; row < end; ++row) {
        curve.path.emplace_back(cells[row].position[panel.horizontalAxis],
                                cells[row].position[panel.verticalAxis]);
      }
    });
  }
  return panel;
}

} // namespace

void AxisRange::include(double value) {
  low = std::min(low, value);
  high = std::max(high, value);
}

AxisRange AxisRange::padded() const {
  const double more = size() > 0.0 ? 0.05 * size() : 0.5;
  return low <= high ? AxisRange{low - more, high + more} : AxisRange{0.0, 1.0};
}

double gridLineSpacing(double size) {
  const double rough = size / 5.0;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double share = rough / power;
  return power * (share < 1.5 ? 1.0 : share < 3.5 ? 2.0 : share < 7.5 ? 5.0 : 10.0);
}

std::vector<double> gridLineValues(const AxisRange& range) {
  const double step = gridLineSpacing(range.size());
  std::vector<double> lines;
  for (double at = std::ceil(range.low / step) * step; at <= range.high; at += step) {
    lines.push_back(at);
  }
  return lines;
}

std::pair<AxisRange, AxisRange> withEqualScale(const AxisRange& horizontal,
                                               const AxisRange& vertical, double width,
                                               double height) {
  const double scale = std::max(horizontal.size() / width, vertical.size() / height);
  const auto widened = [scale](const AxisRange& range, double length) {
    const double middle = 0.5 * (range.low + range.high);
    return AxisRange{middle - 0.5 * scale * length, middle + 0.5 * scale * length};
  };
  return {widened(horizontal, width), widened(vertical, height)};
}

TrajectoryFigure computeTrajectoryFigure(const ExportTable& table) {
  return {{overTime(table, 0), overTime(table, 1), overTime(table, 2)}, fromAbove(table)};
}

} // namespace dewpoint::trajectory
