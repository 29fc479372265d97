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

/// What is to be run.
struct SuiteRequest {
  std::vector<const ScenarioDeclaration*> scenarios;
  std::vector<Grade> grades;
  std::vector<std::string> methods;
  std::optional<int> seeds; ///< per scenario; as declared unless given
  std::uint64_t firstSeed = kFirstReportingSeed;
};

/// One scenario with one seed: its methods share the rendered frames.
struct SuiteJob {
  const ScenarioDeclaration* scenario = nullptr;
  Grade grade = Grade::Ideal;
  std::uint64_t seed = 0;
  std::vector<std::string> methods;
};

/// The declarations meant by names: a family ("S0") or a scenario's own name; all for none. In the
/// catalog's order, each once. NotFound names what is not in the catalog.
Result<std::vector<const ScenarioDeclaration*>>
selectScenarios(std::span<const ScenarioDeclaration> catalog,
                const std::vector<std::string>& names);

/// Every method that some scenario is run with, in the order of the tables, each once: those of
/// suiteMethods(), then those of imageMethods(), which only follow clips of one camera.
std::vector<std::string> allSuiteMethods();

/// The methods meant among those that are known, in their order, each once; all for none. NotFound.
Result<std::vector<std::string>>
selectMethods(const std::vector<std::string>& names,
              const std::vector<std::string>& known = suiteMethods());

/// What is still to do, in order: runs that are neither done nor known to be skipped. A scenario is
/// run in its own grades and by the methods that can: real clips in grade `Real`, all others in the
/// others; clips of one camera by imageMethods().
std::vector<SuiteJob> planSuite(const SuiteRequest& request, const SuiteResults& done,
                                const SkippedRuns& skipped = {});
std::int64_t runCount(const std::vector<SuiteJob>& jobs);

/// All runs of a folder in the order of the report: catalog, grade, method, seed. Runs of scenarios
/// or methods that are not known (any more) stand last.
std::vector<RunKey> reportOrder(const SuiteResults& results,
                                std::span<const ScenarioDeclaration> catalog);

/// Called for each result, one at a time, in the order they finish.
using SuiteSink = std::function<Status(const SuiteResult&)>;
/// Called in the same way for each job that was skipped, and which of its runs there are not.
using SkipSink = std::function<Status(const SuiteJob&, const SkippedRun&)>;

/// Runs the jobs on `threads` threads, one job on one. Results do not depend on `threads`, but the
/// order in which they come, and the processor time they measure, do. Ends early, without the jobs
/// under way, when `stop` says so or with the first error.
///
/// A rendered scenario that cannot make a run (ScenarioDeclaration::make is Undetermined) ends
/// nothing: `skip` gets the job. Without `skip` this is an error like others.
Status runSuite(const std::vector<SuiteJob>& jobs, int threads, const SuiteSink& sink,
                const std::function<bool()>& stop, const SkipSink& skip = {});

} // namespace dewpoint::experiment
