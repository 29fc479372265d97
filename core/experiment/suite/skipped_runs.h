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

/// A run that no method has, because its scenario could not make it: chance has drawn no position
/// at which everything is seen that must be. It is a function of scenario, grade and seed.
struct SkippedRun {
  std::string scenario;
  Grade grade = Grade::Ideal;
  std::uint64_t seed = 0;
  std::string reason; ///< words without a line break

  // clang-tidy 14 takes the 0 that a defaulted <=> compares with for a pointer.
  auto operator<=>(const SkippedRun&) const = default; // NOLINT(modernize-use-nullptr)
};

/// In the order of scenario, grade and seed.
using SkippedRuns = std::set<SkippedRun>;

bool isSkipped(const SkippedRuns& skipped, const std::string& scenario, Grade grade,
               std::uint64_t seed);

/// One sentence for the user.
std::string skippedSentence(const SkippedRun& run);

/// Lines of skipped.csv, without the end of the line; the reason is quoted.
std::string skippedHeader();
std::string skippedText(const SkippedRun& run);
/// The line's run; nothing if it is not a whole one.
std::optional<SkippedRun> parseSkipped(const std::string& line);

/// A scenario in one grade.
struct ScenarioGrade {
  std::string scenario;
  Grade grade = Grade::Ideal;
};

/// The scenarios and grades that have skipped runs and none beside: nothing is known of them.
/// `done` are the keys of the runs that there are.
std::vector<ScenarioGrade> withoutAnyRun(const SkippedRuns& skipped, const std::set<RunKey>& done);

} // namespace dewpoint::experiment
