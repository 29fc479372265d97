// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/bar_measures.h"

#include <cstddef>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Value of SuiteRequirement::lowerLimit if a requirement has no lower limit.
inline constexpr double kNoLowerLimit = -std::numeric_limits<double>::infinity();

/// Requirement for the results of the `dewpoint` method in one grade (level of realism).
struct SuiteRequirement {
  int number = 0;          ///< number of the requirement in the list
  std::string description; ///< what is measured, and in which scenarios
  std::string unit;
  double lowerLimit = 0.0; ///< lower limit of the measured value
  double upperLimit = 0.0;
  /// Names or families of the evaluated scenarios. If empty, all scenarios are evaluated.
  std::vector<std::string> scenarios;
  RequirementMeasure measure;
  /// Grade (level of realism) of the evaluated runs, by name. Nothing is measured if no run has
  /// this grade.
  std::string grade = "ideal";
  /// True if this is an aim for the next version, which the current version may miss.
  bool isAimForNextVersion = false;
};

/// Returns all requirements in list order.
const std::vector<SuiteRequirement>& suiteRequirements();

/// Value that was measured for a requirement.
struct RequirementResult {
  const SuiteRequirement* requirement = nullptr;
  std::size_t runCount = 0;  ///< number of measured runs; 0: not measured
  double value = 0.0;        ///< measured value; NaN if the runs do not contain it
  std::string scenario = {}; ///< scenario that determines the value, if a single one does
  /// Returns whether there are runs and a value for this requirement.
  bool isMeasured() const;
  /// Returns whether the measured value is within the limits [lowerLimit, upperLimit].
  bool isMet() const;
  /// Returns the distance of the value from [lowerLimit, upperLimit]; 0 inside.
  double shortfall() const;
};

/// Measures all requirements with the runs of the `dewpoint` method in `cells`. For each
/// requirement, only runs of its grade are used. Runs with tuning seeds also count; the report
/// shows which seeds were used.
std::vector<RequirementResult> measureRequirements(const std::vector<SuiteCell>& cells);

} // namespace dewpoint::experiment
