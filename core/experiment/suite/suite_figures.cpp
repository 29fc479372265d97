// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_figures.h"

#include "core/base/statistics.h"
#include "core/base/units.h"
#include "core/trajectory/error_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::experiment {
namespace {

constexpr std::size_t kMostPoints = 150; ///< per line: more cannot be told apart
constexpr double kLargestDisk = 120.0;   // square pixels

SvgAxis errorAxis() {
  return {"error, mm", 0.1, 3000.0, true};
}

std::size_t longestRun(std::span<const SuiteCell> cells) {
  std::size_t longest = 1;
  for (const SuiteCell& cell : cells) {
    for (const SuiteResult* run : cell.runs) {
      for (const auto& target : run->trace.errorsMm) {
        longest = std::max(longest, target.size());
      }
    }
  }
  return longest;
}

/// Errors of all runs and targets at the frames [begin, end), ascending.
std::vector<double> errorsAt(const SuiteCell& cell, std::size_t begin, std::size_t end) {
  std::vector<double> errors;
  for (const SuiteResult* run : cell.runs) {
    for (const auto& target : run->trace.errorsMm) {
      for (std::size_t k = begin; k < std::min(end, target.size()); ++k) {
        if (std::isfinite(target[k])) {
          errors.push_back(target[k]);
        }
      }
    }
  }
  std::ranges::sort(errors);
  return errors;
}

SvgSeries overTime(const SuiteCell& cell, std::size_t frameCount) {
  SvgSeries series{plotStyleOfMethod(cell.method), {}, {}, {}, {}};
  const std::size_t step = (frameCount + kMostPoints - 1) / kMostPoints;
  for (std::size_t frame = 0; frame < frameCount; frame += step) {
    const auto errors = errorsAt(cell, frame, frame + step);
    const bool any = !errors.empty();
    const auto value = [&](double fraction) {
      return any ? quantile(errors, fraction) : std::numeric_limits<double>::quiet_NaN();
    };
    series.points.push_back(
        {static_cast<double>(frame) + 0.5 * static_cast<double>(step - 1), value(0.5)});
    series.bandLow.push_back(value(0.1));
    series.bandHigh.push_back(value(0.9));
  }
  return series;
}

/// Frames in which the method could have declared something.
std::size_t frameTotal(const SuiteCell& cell) {
  std::size_t total = 0;
  for (const SuiteResult* run : cell.runs) {
    for (const auto& target : run->trace.errorsMm) {
      total += target.size();
    }
  }
  return std::max<std::size_t>(1, total);
}

SvgSeries distribution(const SuiteCell& cell, std::size_t frameCount) {
  SvgSeries series{plotStyleOfMethod(cell.method), {}, {}, {}, {}};
  const auto errors = errorsAt(cell, 0, frameCount);
  const auto total = static_cast<double>(frameTotal(cell));
  const SvgAxis axis = errorAxis();
  for (std::size_t k = 0; k <= kMostPoints; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(kMostPoints);
    const double error = axis.low * std::pow(axis.high / axis.low, part);
    const auto within = std::ranges::upper_bound(errors, error) - errors.begin();
    series.points.push_back({error, inPercent(static_cast<double>(within)) / total});
  }
  return series;
}

SvgSeries reliabilityOf(const SuiteCell& cell) {
  SvgSeries series{plotStyleOfMethod(cell.method), {}, {}, {}, {}};
  const Reliability table = pooledReliability(cell.runs);
  for (const ReliabilityBin& bin : table.bins) {
    if (bin.forecastCount > 0) {
      const double part =
          static_cast<double>(bin.forecastCount) / static_cast<double>(table.forecastCount);
      series.points.push_back({bin.meanProbability, bin.observedFrequency});
      series.diskAreas.push_back(6.0 + kLargestDisk * part);
    }
  }
  return series;
}

} // namespace

std::string plotStyleOfMethod(const std::string& method) {
  static const std::vector<std::string> order{
      "dewpoint", "barrera", "triangulation", "triangulation-kalman",
      "camshift", "csrt",    "dynamics",      "dewpoint-smoothed"};
  return fmt::format("m{}", std::ranges::find(order, method) - order.begin());
}

Plot errorOverTime(std::span<const SuiteCell> cells) {
  const std::size_t frameCount = longestRun(cells);
  Plot plot{"error over time",
            {"frame", 0.0, static_cast<double>(frameCount), false},
            errorAxis(),
            false,
            {}};
  for (const SuiteCell& cell : cells) {
    plot.series.push_back(overTime(cell, frameCount));
  }
  return plot;
}

Plot errorDistribution(std::span<const SuiteCell> cells) {
  Plot plot{
      "distribution of the error", errorAxis(), {"frames within, %", 0.0, 100.0, false}, false, {}};
  for (const SuiteCell& cell : cells) {
    plot.series.push_back(distribution(cell, longestRun(cells)));
  }
  return plot;
}

Plot reliabilityDiagram(std::span<const SuiteCell> cells) {
  Plot plot{"reliability of the stated existence",
            {"stated P(exists)", 0.0, 1.0, false},
            {"share on the target", 0.0, 1.0, false},
            true,
            {}};
  for (const SuiteCell& cell : cells) {
    plot.series.push_back(reliabilityOf(cell));
  }
  return plot;
}

} // namespace dewpoint::experiment
