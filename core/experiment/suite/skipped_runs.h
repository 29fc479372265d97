// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_row.h"

#include <compare>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Run that was skipped for all methods because its scenario could not create it: the random draws
/// found no position at which everything that must be visible is visible. This depends only on
/// scenario, grade (level of realism) and seed.
struct SkippedRun {
  std::string scenario;
  Grade grade = Grade::Ideal;
  std::uint64_t seed = 0;
  std::string reason; ///< why the run could not be created; a text without a line break

  // clang-tidy 14 mistakes the 0 that a defaulted <=> compares with for a pointer.
  auto operator<=>(const SkippedRun&) const = default; // NOLINT(modernize-use-nullptr)
};

/// Skipped runs, ordered by scenario, grade and seed.
using SkippedRuns = std::set<SkippedRun>;

/// Returns whether the run of this scenario, grade and seed is in the list `skipped`.
bool isSkipped(const SkippedRuns& skipped, const std::string& scenario, Grade grade,
               std::uint64_t seed);

/// Returns a sentence for the user that names a skipped run and the reason.
std::string skippedRunDescription(const SkippedRun& run);

/// Return the header and one line of skipped.csv, without the line end. The reason is in quotation
/// marks.
std::string skippedCsvHeader();
std::string skippedCsvLine(const SkippedRun& run);
/// Parses a line of skipped.csv. Returns nothing if the line is incomplete.
std::optional<SkippedRun> parseSkippedRun(const std::string& line);

/// Scenario in one grade (level of realism).
struct ScenarioGrade {
  std::string scenario;
  Grade grade = Grade::Ideal;
};

/// Returns the pairs of scenario and grade for which there are no results, because all runs were
/// skipped. `done` contains the keys of the existing runs.
std::vector<ScenarioGrade> scenariosWithoutRuns(const SkippedRuns& skipped,
                                                const std::set<RunKey>& done);

} // namespace dewpoint::experiment
