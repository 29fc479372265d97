// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_summary.h"

#include <functional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// One requirement that the method `dewpoint` must reach in the `ideal` grade.
struct SuiteBar {
  int item = 0;         ///< number in the list of requirements
  std::string sentence; ///< what is measured, and where
  std::string unit;
  double low = 0.0; ///< the figure must lie within [low, high]
  double high = 0.0;
  std::vector<std::string> scenarios; ///< names, or families; what it is measured on
  /// The figure of our runs; `others` are those of plain triangulation in the same scenarios.
  std::function<double(const std::vector<const SuiteResult*>& ours,
                       const std::vector<const SuiteResult*>& others)>
      measure;
};

/// All bars, in the order of the list.
const std::vector<SuiteBar>& suiteBars();

struct BarResult {
  const SuiteBar* bar = nullptr;
  std::size_t runs = 0; ///< 0: not measured
  double value = 0.0;   ///< NaN where the runs have no such figure
  bool measured() const;
  bool reached() const;
  double shortfall() const; ///< how far outside [low, high], 0 inside
};

/// What the ideal-grade runs of `dewpoint` among the cells reach; runs of tuning seeds count too:
/// the report says which they are.
std::vector<BarResult> measureBars(const std::vector<SuiteCell>& cells);

} // namespace dewpoint::experiment
