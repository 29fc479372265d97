// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/bar_measures.h"

#include <cstddef>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Lower bound of a requirement that has none.
inline constexpr double kAnyLow = -std::numeric_limits<double>::infinity();

/// One requirement for the method `dewpoint` in one grade.
struct SuiteBar {
  int item = 0;         ///< number in the list of requirements
  std::string sentence; ///< what is measured, and where
  std::string unit;
  double low = 0.0; ///< the value must be within [low, high]
  double high = 0.0;
  /// Names or families of the scenarios that are evaluated. Empty: all.
  std::vector<std::string> scenarios;
  BarMeasure measure;
  /// Name of the grade, as in gradeName(). Nothing is measured if no run has this grade.
  std::string grade = "ideal";
  /// Whether this is an aim of the next version, which the current version may miss.
  bool isAim = false;
};

/// All bars in the order of the list.
const std::vector<SuiteBar>& suiteBars();

/// Result of a requirement.
struct BarResult {
  const SuiteBar* bar = nullptr;
  std::size_t runs = 0;      ///< 0: not measured
  double value = 0.0;        ///< NaN if the runs have no such value
  std::string scenario = {}; ///< scenario that determines the value, if it is only one
  /// Whether the cells have runs and a value for the bar.
  bool measured() const;
  /// Whether the value is within [low, high].
  bool reached() const;
  double shortfall() const; ///< distance from [low, high]; 0 inside
};

/// Results of the runs of `dewpoint` among the cells, each bar in its own grade. Runs of tuning
/// seeds count too; the report shows which seeds they are.
std::vector<BarResult> measureBars(const std::vector<SuiteCell>& cells);

} // namespace dewpoint::experiment
