// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/common/progress.h"
#include "core/experiment/baselines/baseline_methods.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/suite/suite_report.h"
#include "core/experiment/suite/suite_runner.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace dewpoint::app {
namespace {

struct SuiteOptions {
  bool list = false;
  std::vector<std::string> scenarios;
  std::vector<std::string> methods;
  std::string grade = "both";
  std::optional<int> seeds;
  std::uint64_t firstSeed = kFirstReportingSeed;
  int threads = 1;
  std::string folder;
  std::vector<std::string> merged; ///< folders of which one is made
};

int listSuite() {
  for (const ScenarioDeclaration& scenario : scenarioCatalog()) {
    fmt::print("{:<4} {:<28} {:>5} seeds  {}\n", scenario.family, scenario.name, scenario.seeds,
               scenario.sentence);
  }
  fmt::print("\nmethods:");
  for (const std::string& method : suiteMethods()) {
    fmt::print(" {}", method);
  }
  fmt::print("\n");
  return kExitDone;
}

Result<SuiteRequest> requestOf(const SuiteOptions& options) {
  SuiteRequest request;
  const auto scenarios = selectScenarios(scenarioCatalog(), options.scenarios);
  if (!scenarios) {
    return tl::make_unexpected(scenarios.error());
  }
  const auto methods = selectMethods(options.methods);
  if (!methods) {
    return tl::make_unexpected(methods.error());
  }
  request.scenarios = *scenarios;
  request.methods = *methods;
  const auto grade = gradeNamed(options.grade);
  request.grades = grade ? std::vector{*grade} : std::vector{Grade::Ideal, Grade::Room};
  request.seeds = options.seeds;
  request.firstSeed = options.firstSeed;
  return request;
}

Status runJobs(const std::vector<SuiteJob>& jobs, int threads, SuiteStore& store) {
  Progress progress("suite", runCount(jobs));
  std::int64_t finished = 0;
  progress.show(finished);
  const auto sink = [&](const SuiteResult& result) {
    progress.show(++finished);
    return store.append(result);
  };
  auto status = runSuite(jobs, threads, sink, [] { return interruptionRequested(); });
  progress.finish();
  return status;
}

/// The rows of the folder in the order of the report, and the report.
Status writeReport(SuiteStore& store, const std::string& folder) {
  const auto order = reportOrder(store.results(), scenarioCatalog());
  return store.rewrite(order).and_then(
      [&] { return writeSuiteReport(folder, store.results(), order, scenarioCatalog()); });
}

/// Makes the folder hold the runs of others, too.
int mergeSuites(const SuiteOptions& options) {
  SuiteResults all;
  for (const std::string& folder : options.merged) {
    const auto results = SuiteStore::read(folder);
    if (!results) {
      return report(results.error());
    }
    all.insert(results->begin(), results->end());
  }
  auto store = SuiteStore::open(options.folder);
  if (!store) {
    return report(store.error());
  }
  store->take(all);
  if (const auto written = writeReport(*store, options.folder); !written) {
    return report(written.error());
  }
  fmt::print("{} runs in {}; see report.html there.\n", store->results().size(), options.folder);
  return kExitDone;
}

int runSuiteCommand(const SuiteOptions& options) {
  const auto request = requestOf(options);
  if (!request) {
    report(request.error());
    return kExitUsage;
  }
  auto store = SuiteStore::open(options.folder);
  if (!store) {
    return report(store.error());
  }
  catchInterruption();
  const auto jobs = planSuite(*request, store->results());
  const auto run = runJobs(jobs, options.threads, *store);
  const auto written = writeReport(*store, options.folder);
  if (!run) {
    return report(run.error());
  }
  if (!written) {
    return report(written.error());
  }
  const std::int64_t left = runCount(planSuite(*request, store->results()));
  fmt::print("{} runs in {}; see report.html there.\n", store->results().size(), options.folder);
  if (left > 0) {
    fmt::print(stderr, "dewpoint-cli: interrupted with {} runs to do; the same command goes on.\n",
               left);
    return kExitInterrupted;
  }
  return kExitDone;
}

} // namespace

void addSuiteCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand(
      "suite", "Measure all methods on scenes with known truth, and write a report.");
  auto options = std::make_shared<SuiteOptions>();
  command->add_flag("--list", options->list, "Only say which scenarios and methods there are");
  command->add_option("--scenario", options->scenarios, "Family (S0) or scenario; all unless given")
      ->delimiter(',');
  command->add_option("--method", options->methods, "Method; all unless given")->delimiter(',');
  command->add_option("--grade", options->grade, "Images: ideal, room or both")
      ->check(CLI::IsMember({"ideal", "room", "both"}))
      ->capture_default_str();
  command->add_option("--seeds", options->seeds, "Runs per scenario (each has its own number)")
      ->check(CLI::Range(1, 1000000));
  command
      ->add_option("--first-seed", options->firstSeed,
                   fmt::format("First seed; those from {} to {} are for reports",
                               kFirstReportingSeed, kLastReportingSeed))
      ->capture_default_str();
  command->add_option("--threads", options->threads, "Runs at the same time")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_option("--out", options->folder, "Folder to write, or to go on with");
  command
      ->add_option("--merge", options->merged,
                   "Only put the runs of these folders into that of --out, and write its report")
      ->excludes("--scenario", "--method", "--grade", "--seeds", "--first-seed", "--threads",
                 "--list");
  command->callback([options, command, &exitCode] {
    if (options->list) {
      exitCode = listSuite();
    } else if (options->folder.empty()) {
      throw CLI::RequiredError(command->get_option("--out")->get_name());
    } else if (!options->merged.empty()) {
      exitCode = mergeSuites(*options);
    } else {
      exitCode = runSuiteCommand(*options);
    }
  });
}

} // namespace dewpoint::app
