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

/// What the three files of a report are made from.
struct SuiteReport {
  std::vector<SuiteCell> cells;
  std::vector<BarResult> bars;
  std::span<const ScenarioDeclaration> catalog;
  std::vector<std::uint64_t> seeds; ///< ascending, each once
};

std::string summaryCsv(const SuiteReport& report);
std::string reportJson(const SuiteReport& report);
/// Writes report.html, summary.csv and report.json into the folder.
Status writeSuiteReport(const std::filesystem::path& folder, const SuiteResults& results,
                        const std::vector<RunKey>& order,
                        std::span<const ScenarioDeclaration> catalog);

} // namespace dewpoint::experiment
