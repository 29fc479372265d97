// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/baselines/baseline_methods.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/scenarios/scenario.h"
#include "core/experiment/suite/suite_store.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Selection of runs that the suite will perform.
struct SuiteRequest {
  std::vector<const ScenarioDeclaration*> scenarios;
  std::vector<Grade> grades;
  std::vector<std::string> methods;
  /// Number of seeds per scenario; if not set, the scenario's default.
  std::optional<int> seedCount;
  std::uint64_t firstSeed = kFirstReportingSeed;
};

/// Job that runs several methods on one scenario, grade and seed. The methods share the rendered
/// frames.
struct SuiteJob {
  const ScenarioDeclaration* scenario = nullptr;
  Grade grade = Grade::Ideal;
  std::uint64_t seed = 0;
  std::vector<std::string> methods;
};

/// Returns the declarations for the given names, in catalog order and without duplicates. A name is
/// a family ("S0") or a scenario name. Without names, all declarations are returned. Returns
/// NotFound, with the name, if a name is not in the catalog.
Result<std::vector<const ScenarioDeclaration*>>
selectScenarios(std::span<const ScenarioDeclaration> catalog,
                const std::vector<std::string>& names);

/// Returns the methods for all scenarios and clips without duplicates, in the order of the report's
/// tables: first suiteMethods(), then imageClipMethods(), which need clips from a single camera.
std::vector<std::string> allSuiteMethods();

/// Returns the methods with the given names, in the order of `known` and without duplicates.
/// Without names, all methods are returned. Returns NotFound for an unknown name.
Result<std::vector<std::string>>
selectMethods(const std::vector<std::string>& names,
              const std::vector<std::string>& known = suiteMethods());

/// Returns the remaining jobs in order: the requested runs that are neither finished nor known to
/// be skipped. A scenario runs only in its own grades and only with suitable methods. Real clips
/// run in grade `Real`, all other scenarios in the other grades. Clips of one camera run with
/// imageClipMethods().
std::vector<SuiteJob> planSuite(const SuiteRequest& request, const SuiteResults& done,
                                const SkippedRuns& skipped = {});
/// Returns the total number of runs in all jobs.
std::int64_t runCount(const std::vector<SuiteJob>& jobs);

/// Returns the keys of all results in report order: by position of the scenario in the catalog,
/// then by grade, method and seed. Runs of scenarios or methods that no longer exist come last.
std::vector<RunKey> reportOrder(const SuiteResults& results,
                                std::span<const ScenarioDeclaration> catalog);

/// Callback for each result. Calls are made one at a time, in the order in which the runs finish.
using SuiteSink = std::function<Status(const SuiteResult&)>;
/// Callback for each skipped job, with the run that could not be created. Calls are made one at a
/// time.
using SkipSink = std::function<Status(const SuiteJob&, const SkippedRun&)>;

/// Runs the jobs on `threads` threads, each job on one thread, and passes each result to `sink`.
/// The number of threads affects only the order of the results and the measured processor time.
/// When `stop` returns true or the first error occurs, the function returns early and drops
/// unfinished jobs.
///
/// If a rendered scenario cannot create a run (ScenarioDeclaration::make returns Undetermined), the
/// suite continues and `skip` receives the job. Without `skip`, this is an error like any other.
Status runSuite(const std::vector<SuiteJob>& jobs, int threads, const SuiteSink& sink,
                const std::function<bool()>& stop, const SkipSink& skip = {});

} // namespace dewpoint::experiment
