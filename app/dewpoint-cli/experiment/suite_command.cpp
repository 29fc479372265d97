// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/common/progress.h"
#include "core/experiment/baselines/baseline_methods.h"
#include "core/experiment/clips/clip_catalog.h"
#include "core/experiment/clips/real_scenarios.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/scenarios/catalog/catalog.h"
#include "core/experiment/suite/image_clip_run.h"
#include "core/experiment/suite/suite_report.h"
#include "core/experiment/suite/suite_runner.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <utility>

namespace dewpoint::app {
namespace {

struct SuiteOptions {
  bool list = false;
  std::vector<std::string> scenarios;
  std::vector<std::string> methods;
  std::vector<std::string> grades{"both"};
  std::optional<int> seeds;
  std::uint64_t firstSeed = kFirstReportingSeed;
  int threads = 1;
  bool part = false; ///< of a suite that --merge puts together
  std::string folder;
  std::vector<std::string> merged; ///< folders of which one is made
  ClipFolders clips{{}, "bench/clips"};
};

/// The rendered scenarios and the real clips that are there.
struct SuiteCatalog {
  std::vector<ScenarioDeclaration> scenarios;
  std::vector<SkippedClip> skipped; ///< the real clips that are not there
};

SuiteCatalog catalogOf(const SuiteOptions& options) {
  SuiteCatalog catalog;
  catalog.scenarios = scenarioCatalog();
  auto real = makeRealScenarios(options.clips, clipCatalog());
  std::ranges::move(real.scenarios, std::back_inserter(catalog.scenarios));
  catalog.skipped = std::move(real.skippedClips);
  return catalog;
}

int listSuite(const SuiteOptions& options) {
  const SuiteCatalog catalog = catalogOf(options);
  for (const ScenarioDeclaration& scenario : catalog.scenarios) {
    fmt::print("{:<4} {:<28} {:>5} seeds  {}\n", scenario.family, scenario.name, scenario.seedCount,
               scenario.description);
  }
  for (const SkippedClip& clip : catalog.skipped) {
    fmt::print("{}\n", clip.description);
  }
  for (const OmittedRecording& recording : omittedRecordings()) {
    fmt::print("Recording {} is not measured: {}\n", recording.recording, recording.reason);
  }
  fmt::print("\nmethods:");
  for (const std::string& method : suiteMethods()) {
    fmt::print(" {}", method);
  }
  fmt::print("\nmethods for clips of one camera:");
  for (const std::string& method : imageClipMethods()) {
    fmt::print(" {}", method);
  }
  fmt::print("\n");
  return kExitDone;
}

std::vector<Grade> gradesOf(const SuiteOptions& options) {
  return gradesFromNames(options.grades).value_or(std::vector<Grade>()); // names are checked
}

/// Whether a name on the command line means a clip: it is the clip's own, or its family's.
bool means(const std::string& name, const SkippedClip& clip) {
  return clip.name == name || clip.name.starts_with(name + "-");
}

/// The sentences of the clips that are not there and that were requested.
std::vector<std::string> skippedOf(const SuiteOptions& options, const SuiteCatalog& catalog) {
  std::vector<std::string> sentences;
  const auto grades = gradesOf(options);
  if (std::ranges::find(grades, Grade::Real) == grades.end()) {
    return sentences;
  }
  for (const SkippedClip& clip : catalog.skipped) {
    if (options.scenarios.empty() || std::ranges::any_of(options.scenarios, [&](const auto& name) {
          return means(name, clip);
        })) {
      sentences.push_back(clip.description);
    }
  }
  return sentences;
}

/// The scenarios that were requested, without the clips that are not there: the rest is run.
/// NotFound for a name that is unknown, and when nothing is left.
Result<std::vector<const ScenarioDeclaration*>> scenariosOf(const SuiteOptions& options,
                                                            const SuiteCatalog& catalog) {
  std::vector<std::string> names;
  for (const std::string& name : options.scenarios) {
    const bool isFamily =
        std::ranges::find(catalog.scenarios, name, &ScenarioDeclaration::family) !=
        catalog.scenarios.end();
    if (isFamily || std::ranges::none_of(catalog.skipped, [&](const SkippedClip& clip) {
          return means(name, clip);
        })) {
      names.push_back(name);
    }
  }
  if (names.empty() && !options.scenarios.empty()) {
    return failure(ErrorCode::NotFound, "", "--scenario", "its recordings; see --recordings");
  }
  return selectScenarios(catalog.scenarios, names);
}

Result<SuiteRequest> requestOf(const SuiteOptions& options, const SuiteCatalog& catalog) {
  SuiteRequest request;
  const auto scenarios = scenariosOf(options, catalog);
  if (!scenarios) {
    return tl::make_unexpected(scenarios.error());
  }
  const auto methods = selectMethods(options.methods, allSuiteMethods());
  if (!methods) {
    return tl::make_unexpected(methods.error());
  }
  request.scenarios = *scenarios;
  request.methods = *methods;
  request.grades = gradesOf(options);
  request.seedCount = options.seeds;
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
  const auto skip = [&](const SuiteJob& job, const SkippedRun& run) {
    finished += static_cast<std::int64_t>(job.methods.size());
    progress.show(finished);
    return store.append(run);
  };
  auto status = runSuite(
      jobs, threads, sink, [] { return wasInterruptionRequested(); }, skip);
  progress.finish();
  return status;
}

/// The rows of the folder in the order of the report, and the report with its notes.
Status writeReport(SuiteStore& store, const std::string& folder, const SuiteCatalog& catalog,
                   const std::vector<std::string>& notes) {
  const auto order = reportOrder(store.results(), catalog.scenarios);
  return store.rewrite(order).and_then([&] {
    return writeSuiteReport(folder, store.results(), order, catalog.scenarios, notes,
                            store.skippedRuns());
  });
}

/// The sentences of the clips that are not there and have no runs, of results with real clips.
std::vector<std::string> skippedOf(const SuiteResults& results, const SuiteCatalog& catalog) {
  std::set<std::string> clips;
  for (const auto& [key, result] : results) {
    if (key.grade == Grade::Real) {
      clips.insert(key.scenario);
    }
  }
  std::vector<std::string> sentences;
  for (const SkippedClip& clip : catalog.skipped) {
    if (!clips.empty() && !clips.contains(clip.name)) {
      sentences.push_back(clip.description);
    }
  }
  return sentences;
}

/// Says what the folder holds and which runs are skipped. The exit code: a scenario of which not
/// one run could be made is an error, unless the folder is a part of a suite.
int conclude(const SuiteStore& store, const std::string& folder, bool isPart) {
  fmt::print("{} runs in {}; see report.html there.\n", store.results().size(), folder);
  for (const SkippedRun& run : store.skippedRuns()) {
    fmt::print(stderr, "dewpoint-cli: {}\n", skippedRunDescription(run));
  }
  if (!store.skippedRuns().empty()) {
    fmt::print(
        stderr,
        "dewpoint-cli: Skipped runs: {}. The results do not contain them; see skipped.csv.\n",
        store.skippedRuns().size());
  }
  std::set<RunKey> done;
  for (const auto& [key, result] : store.results()) {
    done.insert(key);
  }
  const auto nothing = scenariosWithoutRuns(store.skippedRuns(), done);
  for (const ScenarioGrade& scenario : nothing) {
    fmt::print(stderr, "dewpoint-cli: {}, grade {}: every run was skipped; nothing was measured.\n",
               scenario.scenario, gradeName(scenario.grade));
  }
  return nothing.empty() || isPart ? kExitDone : kExitBadInput;
}

/// Makes the folder hold the runs of others, too.
int mergeSuites(const SuiteOptions& options) {
  SuiteResults all;
  SkippedRuns skipped;
  for (const std::string& folder : options.merged) {
    const auto results = SuiteStore::read(folder);
    if (!results) {
      return reportError(results.error());
    }
    all.insert(results->begin(), results->end());
    const auto skippedThere = SuiteStore::readSkipped(folder);
    if (!skippedThere) {
      return reportError(skippedThere.error());
    }
    skipped.insert(skippedThere->begin(), skippedThere->end());
  }
  auto store = SuiteStore::open(options.folder);
  if (!store) {
    return reportError(store.error());
  }
  store->merge(all);
  store->merge(skipped);
  const SuiteCatalog catalog = catalogOf(options);
  const auto notes = skippedOf(store->results(), catalog);
  if (const auto written = writeReport(*store, options.folder, catalog, notes); !written) {
    return reportError(written.error());
  }
  return conclude(*store, options.folder, options.part);
}

int runSuiteCommand(const SuiteOptions& options) {
  const SuiteCatalog catalog = catalogOf(options);
  const auto skipped = skippedOf(options, catalog);
  for (const std::string& sentence : skipped) {
    fmt::print(stderr, "dewpoint-cli: {}\n", sentence);
  }
  const auto request = requestOf(options, catalog);
  if (!request) {
    reportError(request.error());
    return kExitUsage;
  }
  auto store = SuiteStore::open(options.folder);
  if (!store) {
    return reportError(store.error());
  }
  catchInterruption();
  const auto jobs = planSuite(*request, store->results(), store->skippedRuns());
  const auto run = runJobs(jobs, options.threads, *store);
  const auto written = writeReport(*store, options.folder, catalog, skipped);
  if (!run) {
    return reportError(run.error());
  }
  if (!written) {
    return reportError(written.error());
  }
  const std::int64_t left = runCount(planSuite(*request, store->results(), store->skippedRuns()));
  if (left > 0) {
    fmt::print("{} runs in {}; see report.html there.\n", store->results().size(), options.folder);
    fmt::print(
        stderr,
        "dewpoint-cli: interrupted with {} runs left. Run the same command again to continue.\n",
        left);
    return kExitInterrupted;
  }
  return conclude(*store, options.folder, options.part);
}

} // namespace

void addSuiteCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand(
      "suite", "Measure all methods on scenes with ground truth, and write a report.");
  auto options = std::make_shared<SuiteOptions>();
  command->add_flag("--list", options->list, "Only list the scenarios and methods");
  command
      ->add_option("--scenario", options->scenarios,
                   "Group of scenarios (S0), or a scenario (S0-slow); all if omitted")
      ->delimiter(',');
  command->add_option("--method", options->methods, "Method; all if omitted")->delimiter(',');
  command
      ->add_option("--grade", options->grades,
                   "Quality of the images: ideal, room, wild or real (recordings); several "
                   "separated by commas, or both for ideal and room")
      ->delimiter(',')
      ->check(CLI::IsMember({"ideal", "room", "wild", "real", "both"}))
      ->capture_default_str();
  command
      ->add_option("--recordings", options->clips.recordings,
                   "Folder with the recordings of grade real")
      ->envname("DEWPOINT_DATA");
  command
      ->add_option("--clips", options->clips.truth,
                   "Folder with the ground truth of recordings that do not include it")
      ->capture_default_str();
  command
      ->add_option("--seeds", options->seeds,
                   "Runs per scenario (the default depends on the scenario)")
      ->check(CLI::Range(1, 1000000));
  command
      ->add_option("--first-seed", options->firstSeed,
                   fmt::format("First seed; those from {} to {} are for reports",
                               kFirstReportingSeed, kLastReportingSeed))
      ->capture_default_str();
  command->add_option("--threads", options->threads, "Number of parallel runs")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_flag("--part", options->part,
                    "The folder is only one part of a suite that you will merge with --merge; it "
                    "is then no error if all runs of a scenario are skipped");
  command->add_option("--out", options->folder, "Folder to write, or to continue");
  command
      ->add_option(
          "--merge", options->merged,
          "Only merge the runs of these folders into the folder of --out, and write its report")
      ->excludes("--scenario", "--method", "--grade", "--seeds", "--first-seed", "--threads",
                 "--list");
  command->callback([options, command, &exitCode] {
    if (options->list) {
      exitCode = listSuite(*options);
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
