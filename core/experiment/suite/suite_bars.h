// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/bar_measures.h"

#include <cstddef>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// The lower end of a requirement that has none.
inline constexpr double kAnyLow = -std::numeric_limits<double>::infinity();

/// One requirement for the method `dewpoint` in one grade.
struct SuiteBar {
  int item = 0;         ///< number in the list of requirements
  std::string sentence; ///< what is measured, and where
  std::string unit;
  double low = 0.0; ///< the figure must lie within [low, high]
  double high = 0.0;
  /// Names, or families; what it is measured on. None: all.
  std::vector<std::string> scenarios;
  BarMeasure measure;
  /// As gradeName() writes it. Nothing is measured for a grade that no run has.
  std::string grade = "ideal";
  /// What the next version is to reach: this one is measured against it, and may miss it.
  bool isAim = false;
};

/// All bars, in the order of the list.
const std::vector<SuiteBar>& suiteBars();

struct BarResult {
  const SuiteBar* bar = nullptr;
  std::size_t runs = 0;      ///< 0: not measured
  double value = 0.0;        ///< NaN where the runs have no such figure
  std::string scenario = {}; ///< the one that decides the value, where it is one alone
  bool measured() const;
  bool reached() const;
  double shortfall() const; ///< how far outside [low, high], 0 inside
};

/// What the runs of `dewpoint` among the cells reach, each bar in its own grade; runs of tuning
/// seeds count too: the report says which they are.
std::vector<BarResult> measureBars(const std::vector<SuiteCell>& cells);

} // namespace dewpoint::experiment
