// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/export/export_table.h"

#include "core/base/statistics.h"
#include "core/base/units.h"
#include "core/trajectory/export/path_interpolation.h"
#include "core/trajectory/smoother.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace dewpoint::trajectory {
namespace {

/// Rows farther apart than this many usual distances have others missing between them.
constexpr double kUneven = 1.1;
/// More rows than this are a mistake in the rate; so many cells, of all targets, take 5 GB.
constexpr double kMostRows = 2e7;

tl::unexpected<Error> unusable(std::string field, std::string detail) {
  return failure(ErrorCode::BadValue, "", std::move(field), std::move(detail));
}

Result<std::vector<std::string>> chosenTargets(const Trajectory& trajectory,
                                               const ExportOptions& options) {
  std::vector<std::string> all;
  std::set<std::string> seen;
  for (const TrajectorySample& sample : trajectory.samples) {
    if (seen.insert(sample.target).second) {
      all.push_back(sample.target);
    }
  }
  if (options.targets.empty()) {
    return all;
  }
  for (const std::string& name : options.targets) {
    if (std::ranges::find(all, name) == all.end()) {
      std::string known;
      for (const std::string& target : all) {
        known += (known.empty() ? "" : ", ") + target;
      }
      return failure(
          ErrorCode::NotFound, "", "targets",
          fmt::format("{}; the trajectory has {}", name, known.empty() ? "none" : known));
    }
  }
  std::erase_if(all, [&](const std::string& name) {
    return std::ranges::find(options.targets, name) == options.targets.end();
  });
  return all;
}

bool isWithin(const TrajectorySample& sample, const ExportOptions& options) {
  const auto sampleAt = [&](const RangeBound& end) {
    return end.isFrameNumber ? static_cast<double>(sample.frame) : sample.time;
  };
  return !(options.rangeBegin &&
           sampleAt(*options.rangeBegin) < options.rangeBegin->secondsOrFrame) &&
         !(options.rangeEnd && sampleAt(*options.rangeEnd) > options.rangeEnd->secondsOrFrame);
}

ExportCell cellOf(const TrajectorySample& sample) {
  ExportCell cell;
  cell.hasPosition = sample.isValid;
  if (cell.hasPosition) {
    cell.position = sample.position;
    if (sample.covariance.allFinite() && !sample.covariance.isZero(0.0)) {
      cell.covariance = sample.covariance;
    }
    if (sample.bestParticle && sample.bestParticle->allFinite()) {
      cell.bestParticle = sample.bestParticle;
    }
    cell.effectiveSampleSize = sample.effectiveSampleSize;
    cell.cameraCount = sample.cameraCount;
    cell.isCorrected = sample.isCorrected;
    cell.isAmbiguous = sample.isAmbiguous;
    if (sample.extent && sample.extent->allFinite()) {
      cell.extent = sample.extent;
    }
  }
  return cell;
}

/// The table as recorded: the samples of the chosen targets and span. `after` are the samples that
/// are exported, `live` what was known during the run.
Result<ExportTable> recordedTable(const Trajectory& live, const Trajectory& after,
                                  const ExportOptions& options) {
  const auto targets = chosenTargets(live, options);
  if (!targets) {
    return tl::make_unexpected(targets.error());
  }
  ExportTable table;
  table.targets = *targets;
  std::map<std::string, std::size_t> columns;
  for (const std::string& name : table.targets) {
    columns.emplace(name, columns.size());
  }
  std::map<double, std::size_t> rows;
  std::vector<const TrajectorySample*> chosen;
  for (const TrajectorySample& sample : after.samples) {
    if (!columns.contains(sample.target)) {
      continue;
    }
    if (!std::isfinite(sample.time)) {
      return unusable("time_s", "an export needs the time of each sample");
    }
    if (isWithin(sample, options)) {
      rows.emplace(sample.time, 0);
    }
  }
  if (rows.empty()) {
    return unusable("span", "there is no sample of the chosen targets in the chosen span");
  }
  for (auto& [time, row] : rows) {
    row = table.times.size();
    table.times.push_back(time);
    table.frames.push_back(static_cast<std::int64_t>(row));
  }
  // A file in which every row is of another target would take the square of its size.
  if (static_cast<double>(rows.size()) * static_cast<double>(table.targets.size()) > kMostRows) {
    return unusable("targets", fmt::format("{} targets at {} times cannot be written in one table",
                                           table.targets.size(), rows.size()));
  }
  table.cells.assign(table.targets.size(), std::vector<ExportCell>(rows.size()));
  for (std::size_t k = 0; k < after.samples.size(); ++k) {
    const TrajectorySample& sample = after.samples[k];
    const auto column = columns.find(sample.target);
    if (column == columns.end() || !isWithin(sample, options)) {
      continue;
    }
    if (sample.isValid && !sample.position.allFinite()) {
      return unusable(fmt::format("target {}, frame {}", sample.target, sample.frame),
                      "the position is not a finite number");
    }
    const std::size_t row = rows.at(sample.time);
    if (sample.frame >= 0) {
      table.frames[row] = sample.frame;
    }
    ExportCell& cell = table.cells[column->second][row];
    cell = cellOf(sample);
    cell.isFilled = cell.hasPosition && !live.samples[k].isValid;
    if (cell.isFilled && options.gapRule == GapRule::LeaveEmpty) {
      cell = ExportCell();
    }
  }
  return table;
}

/// The usual number of rows per second.
double usualRate(const std::vector<double>& times) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < times.size(); ++k) {
    steps.push_back(times[k] - times[k - 1]);
  }
  if (steps.empty()) {
    return 0.0;
  }
  // Times of 30 frames/s are often rounded to milliseconds or less.
  const double rate = 1.0 / upperMedian(std::move(steps));
  return std::abs(rate - std::round(rate)) < 0.002 * rate ? std::round(rate) : rate;
}

bool isEven(const std::vector<double>& times, double rate) {
  for (std::size_t k = 1; k < times.size(); ++k) {
    const double step = (times[k] - times[k - 1]) * rate;
    if (step > kUneven || step < 2.0 - kUneven) {
      return false;
    }
  }
  return true;
}

/// One target's cells that hold something, between which others are found.
class Column {
public:
  Column(const ExportTable& table, std::size_t target, double longestStep)
      : cells_(table.cells[target]), times_(table.times), longestStep_(longestStep) {
    for (std::size_t row = 0; row < cells_.size(); ++row) {
      if (cells_[row].hasPosition) {
        rows_.push_back(row);
      }
    }
  }

  /// The cell at a time; `isFilled` if that is in a gap.
  ExportCell at(double time) const {
    const auto next =
        std::ranges::lower_bound(rows_, time, {}, [&](std::size_t row) { return times_[row]; });
    if (next != rows_.end() && times_[*next] - time < 1e-6) {
      return cells_[*next];
    }
    if (next != rows_.begin() && time - times_[*std::prev(next)] < 1e-6) {
      return cells_[*std::prev(next)];
    }
    if (next == rows_.begin() || next == rows_.end()) {
      return {};
    }
    const auto last = std::prev(next);
    const std::size_t a = *last;
    const std::size_t b = *next;
    if (times_[b] - times_[a] > longestStep_) {
      return {};
    }
    return between(a, b, last == rows_.begin() ? a : *std::prev(last),
                   std::next(next) == rows_.end() ? b : *std::next(next), time);
  }

private:
  TimedPosition positionAt(std::size_t row) const { return {times_[row], cells_[row].position}; }

  ExportCell between(std::size_t a, std::size_t b, std::size_t before, std::size_t after,
                     double time) const {
    // A place on the far side of another gap says little of the slope.
    const auto neighbor = [&](std::size_t row, std::size_t end) {
      return row != end && std::abs(times_[row] - times_[end]) <= times_[b] - times_[a] + 1e-6
                 ? std::optional(positionAt(row))
                 : std::nullopt;
    };
    ExportCell cell;
    cell.hasPosition = true;
    cell.isFilled = b > a + 1 || cells_[a].isFilled || cells_[b].isFilled;
    cell.position = interpolatedPosition(neighbor(before, a), positionAt(a), positionAt(b),
                                         neighbor(after, b), time);
    const double share = (time - times_[a]) / (times_[b] - times_[a]);
    // Within a gap nobody knows how far it is off; between neighboring frames, whose errors are
    // alike, no more than they are.
    if (b == a + 1 && cells_[a].covariance && cells_[b].covariance) {
      cell.covariance = (1.0 - share) * *cells_[a].covariance + share * *cells_[b].covariance;
    }
    const ExportCell& nearest = cells_[share < 0.5 ? a : b];
    cell.effectiveSampleSize = nearest.effectiveSampleSize;
    cell.isCorrected = nearest.isCorrected;
    cell.isAmbiguous = cells_[a].isAmbiguous || cells_[b].isAmbiguous;
    cell.extent = nearest.extent;
    cell.cameraCount = b == a + 1 ? std::min(cells_[a].cameraCount, cells_[b].cameraCount) : 0;
    return cell;
  }

  const std::vector<ExportCell>& cells_;
  const std::vector<double>& times_;
  double longestStep_;
  std::vector<std::size_t> rows_;
};

/// The same at other times; gaps are filled if asked for.
ExportTable atTimes(const ExportTable& table, std::vector<double> times,
                    std::vector<std::int64_t> frames, const ExportOptions& options) {
  ExportTable result = table;
  result.times = std::move(times);
  result.frames = std::move(frames);
  const double usualStep = table.rowsPerSecond > 0.0 ? 1.0 / table.rowsPerSecond : 0.0;
  const double longest = options.gapRule == GapRule::Fill
                             ? std::max(options.maxFilledGapSeconds + 1e-6, kUneven * usualStep)
                             : 1.5 * usualStep;
  for (std::size_t target = 0; target < table.targets.size(); ++target) {
    const Column column(table, target, longest);
    auto& cells = result.cells[target];
    cells.clear();
    for (const double time : result.times) {
      cells.push_back(column.at(time));
    }
  }
  return result;
}

Result<ExportTable> resampled(const ExportTable& table, double rate, const ExportOptions& options) {
  const double span = table.times.back() - table.times.front();
  const double cells = span * rate * static_cast<double>(table.targets.size());
  if (!std::isfinite(rate) || rate <= 0.0 || !(cells <= kMostRows)) {
    return unusable("rate", fmt::format("{} rows per second cannot be written", rate));
  }
  std::vector<double> times;
  std::vector<std::int64_t> frames;
  // A little more than the span, so that rounding does not take the last row.
  for (std::int64_t k = 0; static_cast<double>(k) <= span * rate + 1e-3; ++k) {
    times.push_back(table.times.front() + static_cast<double>(k) / rate);
    frames.push_back(k);
  }
  ExportTable result = atTimes(table, std::move(times), std::move(frames), options);
  result.rowsPerSecond = rate;
  return result;
}

void rotateAndScale(ExportTable& table) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  if (table.axes == WorldAxes::YUp) {
    turn << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  }
  const double scale = table.unit == LengthUnit::Meter ? 1.0 : inMillimeters(1.0);
  for (auto& column : table.cells) {
    for (ExportCell& cell : column) {
      cell.position = scale * (turn * cell.position);
      if (cell.covariance) {
        const Eigen::Matrix3d rotated = turn * *cell.covariance * turn.transpose();
        cell.covariance = scale * scale * rotated;
        table.hasCovariance = true;
      }
      if (cell.bestParticle) {
        cell.bestParticle = Eigen::Vector3d(scale * (turn * *cell.bestParticle));
        table.hasBestParticles = true;
      }
      table.hasCorrectedCells = table.hasCorrectedCells || cell.isCorrected;
      table.hasAmbiguousCells = table.hasAmbiguousCells || cell.isAmbiguous;
      if (cell.extent) {
        const Eigen::Matrix3d rotated = turn * *cell.extent * turn.transpose();
        cell.extent = scale * scale * rotated;
        table.hasExtent = true;
      }
    }
  }
}

void describe(ExportTable& table, const Trajectory& trajectory, const ExportOptions& options) {
  table.headerEntries = trajectory.header.entries;
  table.headerEntries.emplace_back(
      "estimates", options.usesSmoothedEstimates ? "smoothed after the run" : "live");
  if (options.gapRule == GapRule::Fill) {
    table.headerEntries.emplace_back("gaps",
                                     fmt::format("filled up to {} s", options.maxFilledGapSeconds));
  }
  if (options.rowsPerSecond) {
    table.headerEntries.emplace_back("resampled", fmt::format("{} Hz", *options.rowsPerSecond));
  }
  if (!options.exportDate.empty()) {
    table.headerEntries.emplace_back("exported", options.exportDate);
  }
}

} // namespace

std::size_t ExportTable::gapCount() const {
  std::size_t count = 0;
  for (const auto& column : cells) {
    count += static_cast<std::size_t>(
        std::ranges::count_if(column, [](const ExportCell& cell) { return !cell.hasPosition; }));
  }
  return count;
}

Result<ExportTable> makeExportTable(const Trajectory& trajectory, const ExportOptions& options,
                                    const TableDefaults& defaults,
                                    const std::function<bool(double)>& progress) {
  const Trajectory after =
      options.usesSmoothedEstimates
          ? smoothedTrajectory(trajectory, SmootherOptions{options.maxFilledGapSeconds, progress})
          : Trajectory();
  auto table =
      recordedTable(trajectory, options.usesSmoothedEstimates ? after : trajectory, options);
  if (!table) {
    return table;
  }
  table->rowsPerSecond = usualRate(table->times);
  table->recordedRowsPerSecond = table->rowsPerSecond;
  const double span = table->times.back() - table->times.front();
  table->recordedRowCount = 1 + static_cast<std::size_t>(std::lround(span * table->rowsPerSecond));
  const bool mustBeEven = defaults.requiresEvenlySpacedRows && table->rowsPerSecond > 0.0 &&
                          !isEven(table->times, table->rowsPerSecond);
  if (options.rowsPerSecond || mustBeEven) {
    table = resampled(*table, options.rowsPerSecond.value_or(table->rowsPerSecond), options);
  } else if (options.gapRule == GapRule::Fill) {
    table = atTimes(*table, table->times, table->frames, options);
  }
  if (!table) {
    return table;
  }
  if (table->gapCount() == table->targets.size() * table->rowCount()) {
    return unusable("span", "no position of the chosen targets is known in the chosen span");
  }
  table->axes = options.axes.value_or(defaults.axes);
  table->unit = options.unit.value_or(defaults.unit);
  table->writesHeader = options.writesHeader;
  rotateAndScale(*table);
  describe(*table, trajectory, options);
  return table;
}

} // namespace dewpoint::trajectory
