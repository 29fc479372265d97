// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/scenarios/scenario.h"

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Error limit in meters. A target counts as followed if it is declared present and its error is
/// below this limit.
inline constexpr double kFollowGate = 0.03;
/// Largest distance, in meters, at which the metrics match an estimate to a true target: the gate
/// of CLEAR MOT and HOTA, and the cutoff of GOSPA.
inline constexpr double kMatchGate = 0.1;
/// Largest number of frames until convergence at which a run counts as quick.
inline constexpr double kQuickFrames = 5.0;
/// Number of bins in the reliability diagram.
inline constexpr int kReliabilityBins = 10;

/// Returns the grades (levels of realism) with these names, without duplicates, easiest first. The
/// name "both" stands for the grades "ideal" and "room". Returns nothing if a name is unknown or
/// the list is empty.
std::optional<std::vector<Grade>> gradesFromNames(const std::vector<std::string>& names);

/// Identifies a run of the suite.
struct RunKey {
  std::string scenario;
  Grade grade = Grade::Ideal;
  std::string method;
  std::uint64_t seed = 0;

  // clang-tidy 14 mistakes the 0 that a defaulted <=> compares with for a pointer.
  auto operator<=>(const RunKey&) const = default; // NOLINT(modernize-use-nullptr)
};

/// Metrics of one run: one row of runs.csv. For the meaning of each value, see suiteColumns(). A
/// value that does not apply is empty. A value is infinite if an expected event never happened.
struct SuiteRow {
  using Value = std::optional<double>;
  RunKey key;
  Value rmseMm;
  Value medianErrorMm;
  Value p95ErrorMm;
  Value maxErrorMm;
  Value depthErrorMm;
  Value lateralErrorMm;
  Value biasMm;
  Value depthBiasMm;
  Value jitterMm;
  Value framesToConverge;
  Value framesToReacquire;
  Value framesToDeclareLoss;
  Value lostPercent;
  Value falseAlarmPercent;
  Value nees;
  Value coverage95Percent;
  Value coverage50Percent;
  Value confidentlyWrongPercent;
  Value wrongPercent;
  Value wrongWhenConfidentPercent;
  Value confidentInTiePercent;
  Value nearCentroidPercent;
  Value centroidErrorPercent;
  Value sizeErrorPercent;
  Value gospaMm;
  Value mota;
  Value hota;
  Value identitySwitches;
  Value existenceEce;
  Value blackoutRmseMm;
  Value blackoutCoverage95Percent;
  Value largestStepMm;
  Value rmsePx;
  Value boxSuccess;
  Value usPerFrame;
  Value frameCount;
};

/// Describes a column of runs.csv after the first four, which identify the run.
struct SuiteColumn {
  const char* name;
  SuiteRow::Value SuiteRow::*value;
  const char* description; ///< meaning of the column, for the report
};
/// Returns the columns in the order of runs.csv.
std::span<const SuiteColumn> suiteColumns();

/// Counts for one bin of the reliability diagram: the estimates whose P(exists) is within the bin,
/// and how many of these were on the target.
struct ReliabilityCount {
  std::int64_t count = 0;
  double probabilitySum = 0.0;
  std::int64_t hitCount = 0;
};

/// Data of one run for the plots: one line of traces.csv.
struct SuiteTrace {
  RunKey key;
  /// Distance of the estimate from the truth in millimeters, per target and frame. NaN if the
  /// method does not declare the target present, or if the target is absent.
  std::vector<std::vector<double>> errorsMm;
  std::vector<ReliabilityCount> reliabilityCounts; ///< kReliabilityBins entries
};

/// Return the header and one line of runs.csv and of traces.csv, without the line end. Numbers have
/// six significant digits; errors in traces.csv have four. If a line is parsed and written again,
/// the result is identical.
std::string rowHeader();
std::string rowText(const SuiteRow& row);
std::string traceHeader();
std::string traceText(const SuiteTrace& trace);

/// Parse a line of runs.csv and of traces.csv. Return nothing if the line is incomplete.
std::optional<SuiteRow> parseRow(const std::string& line);
std::optional<SuiteTrace> parseTrace(const std::string& line);

} // namespace dewpoint::experiment
