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

/// Run that no method has, because its scenario could not make it: the random draws found no
/// position at which all that must be visible is visible. This depends only on scenario, grade and
/// seed.
struct SkippedRun {
  std::string scenario;
  Grade grade = Grade::Ideal;
  std::uint64_t seed = 0;
  std::string reason; ///< text without a line break

  // clang-tidy 14 mistakes the 0 that a defaulted <=> compares with for a pointer.
  auto operator<=>(const SkippedRun&) const = default; // NOLINT(modernize-use-nullptr)
};

/// Skipped runs in the order of scenario, grade and seed.
using SkippedRuns = std::set<SkippedRun>;

/// Whether the run is among the skipped ones.
bool isSkipped(const SkippedRuns& skipped, const std::string& scenario, Grade grade,
               std::uint64_t seed);

/// One sentence for the user.
std::string skippedSentence(const SkippedRun& run);

/// Lines of skipped.csv, without the line end; the reason is quoted.
std::string skippedHeader();
std::string skippedText(const SkippedRun& run);
/// Parses a line; nothing if it is incomplete.
std::optional<SkippedRun> parseSkipped(const std::string& line);

/// Scenario in one grade.
struct ScenarioGrade {
  std::string scenario;
  Grade grade = Grade::Ideal;
};

/// Scenarios and grades with skipped runs and no others, so they have no results. `done` are the
/// keys of the existing runs.
std::vector<ScenarioGrade> withoutAnyRun(const SkippedRuns& skipped, const std::set<RunKey>& done);

} // namespace dewpoint::experiment
