// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/scenarios/scenario.h"
#include "core/experiment/suite/suite_bars.h"
#include "core/experiment/suite/suite_summary.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Data for the files of a report.
struct SuiteReport {
  std::vector<SuiteCell> cells;
  std::vector<BeliefSummary> beliefSummaries;
  std::vector<RequirementResult> requirements;
  std::span<const ScenarioDeclaration> catalog;
  std::vector<std::uint64_t> seeds; ///< ascending, without duplicates
  std::vector<std::string> notes;   ///< sentences about missing data
  SkippedRuns skippedRuns;          ///< runs that could not be created
};

/// Returns the results as CSV, with one line per cell (scenario, grade and method).
std::string summaryCsv(const SuiteReport& report);
/// Returns the belief metrics as CSV, with one line per grade, method and metric: the median over
/// the scenarios, and the value and name of the worst scenario.
std::string beliefCsv(const SuiteReport& report);
/// Returns the report as JSON.
std::string reportJson(const SuiteReport& report);
/// Writes report.html, summary.csv, belief.csv and report.json into the folder. `order` contains
/// the keys of all runs in report order, `notes` sentences about missing data.
Status writeSuiteReport(const std::filesystem::path& folder, const SuiteResults& results,
                        const std::vector<RunKey>& order,
                        std::span<const ScenarioDeclaration> catalog,
                        const std::vector<std::string>& notes = {},
                        const SkippedRuns& skipped = {});

} // namespace dewpoint::experiment
