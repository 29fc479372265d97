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

/// Selection of runs.
struct SuiteRequest {
  std::vector<const ScenarioDeclaration*> scenarios;
  std::vector<Grade> grades;
  std::vector<std::string> methods;
  std::optional<int> seeds; ///< per scenario; as declared unless given
  std::uint64_t firstSeed = kFirstReportingSeed;
};

/// One scenario with one seed. Its methods share the rendered frames.
struct SuiteJob {
  const ScenarioDeclaration* scenario = nullptr;
  Grade grade = Grade::Ideal;
  std::uint64_t seed = 0;
  std::vector<std::string> methods;
};

/// Declarations that names refer to: a family ("S0") or the name of a scenario; all if there are no
/// names. In the order of the catalog, each once. NotFound gives the name that is not in the
/// catalog.
Result<std::vector<const ScenarioDeclaration*>>
selectScenarios(std::span<const ScenarioDeclaration> catalog,
                const std::vector<std::string>& names);

/// All methods of any scenario in the order of the tables, each once: those of suiteMethods(), then
/// those of imageMethods(), which only follow clips of one camera.
std::vector<std::string> allSuiteMethods();

/// Methods that names refer to, in the order of `known`, each once; all if there are no names.
/// NotFound.
Result<std::vector<std::string>>
selectMethods(const std::vector<std::string>& names,
              const std::vector<std::string>& known = suiteMethods());

/// Jobs that remain, in order: runs that are neither done nor known to be skipped. A scenario runs
/// only in its own grades and with suitable methods: real clips in grade `Real`, all others in the
/// other grades, clips of one camera with imageMethods().
std::vector<SuiteJob> planSuite(const SuiteRequest& request, const SuiteResults& done,
                                const SkippedRuns& skipped = {});
/// Number of runs of all jobs.
std::int64_t runCount(const std::vector<SuiteJob>& jobs);

/// All runs of a folder in the order of the report: catalog, grade, method, seed. Runs of scenarios
/// or methods that no longer exist come last.
std::vector<RunKey> reportOrder(const SuiteResults& results,
                                std::span<const ScenarioDeclaration> catalog);

/// Called for each result, one at a time, in the order in which they finish.
using SuiteSink = std::function<Status(const SuiteResult&)>;
/// Called in the same way for each skipped job, with the run that could not be made.
using SkipSink = std::function<Status(const SuiteJob&, const SkippedRun&)>;

/// Runs the jobs on `threads` threads, each job on one thread. `threads` does not affect the
/// results, but it affects their order and the measured processor time. Ends early, without the
/// unfinished jobs, when `stop` returns true or at the first error.
///
/// If a rendered scenario cannot make a run (ScenarioDeclaration::make is Undetermined), the suite
/// continues and `skip` receives the job. Without `skip`, this is an error like any other.
Status runSuite(const std::vector<SuiteJob>& jobs, int threads, const SuiteSink& sink,
                const std::function<bool()>& stop, const SkipSink& skip = {});

} // namespace dewpoint::experiment
