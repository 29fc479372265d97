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

/// A target counts as followed when it is declared present nearer to the truth than this, meters:
/// what the suite requires.
inline constexpr double kFollowGate = 0.03;
/// Gate of the metrics of several targets (GOSPA's cutoff, CLEAR MOT, HOTA), meters.
inline constexpr double kMatchGate = 0.1;
/// A start counts as quick when it takes no more frames than this.
inline constexpr double kQuickFrames = 5.0;
/// Bins of the reliability diagram.
inline constexpr int kReliabilityBins = 10;

/// The grades of a list of names, each once, the easiest first; "both" stands for ideal and room.
/// Nothing if a name is unknown or the list is empty.
std::optional<std::vector<Grade>> gradesNamed(const std::vector<std::string>& names);

/// Which run of the suite.
struct RunKey {
  std::string scenario;
  Grade grade = Grade::Ideal;
  std::string method;
  std::uint64_t seed = 0;

  // clang-tidy 14 takes the 0 that a defaulted <=> compares with for a pointer.
  auto operator<=>(const RunKey&) const = default; // NOLINT(modernize-use-nullptr)
};

/// What one run measured: one row of runs.csv. Empty where a figure makes no sense; infinite where
/// something that should have happened never did.
struct SuiteRow {
  using Figure = std::optional<double>;
  RunKey key;
  Figure rmseMm;
  Figure medianMm;
  Figure p95Mm;
  Figure maxMm;
  Figure depthMm;
  Figure lateralMm;
  Figure biasMm;
  Figure depthBiasMm;
  Figure jitterMm;
  Figure framesToConverge;
  Figure framesToReacquire;
  Figure framesToDeclareLoss;
  Figure lostPercent;
  Figure falseAlarmPercent;
  Figure nees;
  Figure coverage95Percent;
  Figure coverage50Percent;
  Figure sureAndWrongPercent;
  Figure wrongPercent;
  Figure wrongWhenSurePercent;
  Figure sureOfTiePercent;
  Figure nearCentroidPercent;
  Figure centroidErrorPercent;
  Figure sizeErrorPercent;
  Figure gospaMm;
  Figure mota;
  Figure hota;
  Figure identitySwitches;
  Figure existenceEce;
  Figure blackoutRmseMm;
  Figure blackoutCoverage95Percent;
  Figure largestStepMm;
  Figure rmsePx;
  Figure success;
  Figure usPerFrame;
  Figure frames;
};

/// A column of runs.csv behind the four of the key.
struct SuiteColumn {
  const char* name;
  SuiteRow::Figure SuiteRow::*figure;
  const char* sentence; ///< what it means, for the report
};
std::span<const SuiteColumn> suiteColumns();

/// How often P(exists) within one tenth was stated, and what came of it.
struct ReliabilityCount {
  std::int64_t count = 0;
  double probabilitySum = 0.0;
  std::int64_t happened = 0;
};

/// What the plots need of one run: one line of traces.csv.
struct SuiteTrace {
  RunKey key;
  /// Per target and frame: distance of the estimate to the truth in millimeters; NaN where the
  /// method does not declare the target present, or where it is not there.
  std::vector<std::vector<double>> errorsMm;
  std::vector<ReliabilityCount> reliability; ///< kReliabilityBins
};

/// Lines of the two files, without the end of the line. Numbers have six (errors four) significant
/// digits: what is read back gives the same line again.
std::string rowHeader();
std::string rowText(const SuiteRow& row);
std::string traceHeader();
std::string traceText(const SuiteTrace& trace);

/// The line's row; nothing if it is not a whole one.
std::optional<SuiteRow> parseRow(const std::string& line);
std::optional<SuiteTrace> parseTrace(const std::string& line);

} // namespace dewpoint::experiment
