// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/skipped_runs.h"

#include "core/base/text_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace dewpoint::experiment {
namespace {

constexpr const char* kSkippedHeader = "scenario,grade,seed,reason";

/// As CSV has it: in quotation marks, those within doubled.
std::string quoted(const std::string& text) {
  std::string result(1, '"');
  for (const char letter : text) {
    result += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  }
  return result + '"';
}

/// The text that was quoted; nothing if this is not all of it.
std::optional<std::string> unquoted(const std::string& text) {
  if (text.size() < 2 || text.front() != '"' || text.back() != '"') {
    return std::nullopt;
  }
  std::string result;
  for (std::size_t k = 1; k + 1 < text.size(); ++k) {
    if (text[k] == '"') {
      ++k; // the first of two
      if (k + 1 >= text.size() || text[k] != '"') {
        return std::nullopt;
      }
    }
    result += text[k];
  }
  return result;
}

} // namespace

bool isSkipped(const SkippedRuns& skipped, const std::string& scenario, Grade grade,
               std::uint64_t seed) {
  const auto first = skipped.lower_bound({scenario, grade, seed, ""});
  return first != skipped.end() && first->scenario == scenario && first->grade == grade &&
         first->seed == seed;
}

std::string skippedRunDescription(const SkippedRun& run) {
  return fmt::format("{}, grade {}, seed {} is skipped: {}.", run.scenario, gradeName(run.grade),
                     run.seed, run.reason);
}

std::string skippedCsvHeader() {
  return kSkippedHeader;
}

std::string skippedCsvLine(const SkippedRun& run) {
  return fmt::format("{},{},{},{}", run.scenario, gradeName(run.grade), run.seed,
                     quoted(run.reason));
}

std::optional<SkippedRun> parseSkippedRun(const std::string& line) {
  const std::size_t first = line.find(',');
  const std::size_t second = line.find(',', first + 1);
  const std::size_t third = line.find(',', second + 1);
  if (first == 0 || first == std::string::npos || second == std::string::npos ||
      third == std::string::npos) {
    return std::nullopt;
  }
  const auto grade = gradeFromName(line.substr(first + 1, second - first - 1));
  const auto seed =
      toNumber<std::uint64_t>(std::string_view(line).substr(second + 1, third - second - 1));
  const auto reason = unquoted(line.substr(third + 1));
  if (!grade || !seed || !reason) {
    return std::nullopt;
  }
  return SkippedRun{line.substr(0, first), *grade, *seed, *reason};
}

std::vector<ScenarioGrade> scenariosWithoutRuns(const SkippedRuns& skipped,
                                                const std::set<RunKey>& done) {
  std::vector<ScenarioGrade> found;
  for (const SkippedRun& run : skipped) {
    const bool isKnown =
        !found.empty() && found.back().scenario == run.scenario && found.back().grade == run.grade;
    const auto isSame = [&](const RunKey& key) {
      return key.scenario == run.scenario && key.grade == run.grade;
    };
    if (!isKnown && std::ranges::none_of(done, isSame)) {
      found.push_back({run.scenario, run.grade});
    }
  }
  return found;
}

} // namespace dewpoint::experiment
