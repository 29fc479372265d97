// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/experiment/experiment_commands.h"
#include "core/base/text_file.h"
#include "core/base/units.h"
#include "core/experiment/report/report_folder.h"
#include "core/experiment/studies/convergence_csv.h"
#include "core/experiment/studies/wand_study.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

namespace dewpoint::app {
namespace {

constexpr int kDriftRuns = 50;

struct ConvergenceOptions {
  std::uint64_t first = kFirstReportingSeed;
  int runs = 100;
  std::string folder; ///< for convergence.csv and drift.csv; empty: they are not written
};

Status writeConvergence(const std::string& folder, const std::vector<ConvergenceResult>& results,
                        const std::vector<DriftResult>& drifts) {
  const std::filesystem::path out(folder);
  return writeTextFile(out / "convergence.csv", convergenceCsv(results)).and_then([&] {
    return writeTextFile(out / "drift.csv", driftCsv(drifts));
  });
}

/// Over the first 5 and the first 40 iterations.
Result<std::vector<DriftResult>> driftsOf(const ConvergenceOptions& options) {
  std::vector<DriftResult> drifts;
  for (const int iterations : {5, 40}) {
    const auto drift = measureDrift(kDriftRuns, iterations, options.first);
    if (!drift) {
      return tl::make_unexpected(drift.error());
    }
    drifts.push_back({options.first, kDriftRuns, iterations, *drift});
  }
  return drifts;
}

int studyBarrera(const ConvergenceOptions& options) {
  if (!options.folder.empty()) {
    if (const auto folder = prepareReportFolder(options.folder, "convergence.csv"); !folder) {
      return reportError(folder.error());
    }
  }
  std::vector<ConvergenceResult> results;
  fmt::print("{:<50} {:>11} {:>11} {:>11} {:>9} {:>11}\n", "case", "converged", "within 3 cm",
             "iterations", "RMSE mm", "depth bias");
  for (const auto& setup : barreraConvergenceCases(options.runs, options.first)) {
    const auto result = studyConvergence(setup);
    if (!result) {
      return reportError(result.error());
    }
    fmt::print("{:<50} {:>4} / {:<4} {:>11} {:>11.1f} {:>9.1f} {:>8.1f} mm\n", setup.name,
               result->convergedRunCount, setup.runCount, result->accurateRunCount,
               result->medianIterations, inMillimeters(result->rmse),
               inMillimeters(result->depthBias));
    std::fflush(stdout);
    results.push_back(*result);
  }
  const auto drifts = driftsOf(options);
  if (!drifts) {
    return reportError(drifts.error());
  }
  for (const DriftResult& drift : *drifts) {
    fmt::print("drift away from a single camera: {:.1f} mm per iteration over the first {}\n",
               inMillimeters(drift.metersPerIteration), drift.iterationCount);
  }
  fmt::print("Seeds {}.\n", describeSeeds(options.first, options.runs));
  if (!options.folder.empty()) {
    if (const auto written = writeConvergence(options.folder, results, *drifts); !written) {
      return reportError(written.error());
    }
  }
  return kExitDone;
}

void printTrial(const WandTrial& trial) {
  fmt::print("{:>6} {:<33}", trial.seed, wandCaseName(trial.kind));
  if (!trial.failureReason.empty()) {
    fmt::print(" {}\n", trial.failureReason);
    return;
  }
  fmt::print(" {:>9.2f} {:>8.2f} {:>8.3f} {:>9.2f} {:>7.3f} {:>6} {:>7.2f}  {}\n",
             inMillimeters(trial.cameraPositionRms), inMillimeters(trial.ballPositionRms),
             inPercent(trial.scaleError), inMilliseconds(trial.clockOffsetError),
             trial.medianReprojectionErrorPx, trial.viewCount, trial.solveSeconds,
             trial.hasPassed ? "yes" : "no");
  std::fflush(stdout);
}

int studyWands(std::uint64_t first, int seeds, const WandRecording& recording) {
  catchInterruption();
  fmt::print("{:>6} {:<33} {:>9} {:>8} {:>8} {:>9} {:>7} {:>6} {:>7}  within the limit\n", "seed",
             "case", "camera mm", "point mm", "scale %", "offset ms", "px", "views", "solve s");
  std::map<WandCase, std::vector<WandTrial>> all;
  for (int k = 0; k < seeds && !wasInterruptionRequested(); ++k) {
    studyWand(first + static_cast<std::uint64_t>(k), recording, [&](const WandTrial& trial) {
      printTrial(trial);
      all[trial.kind].push_back(trial);
      return !wasInterruptionRequested();
    });
  }
  for (const auto& [kind, trials] : all) {
    WandTrial worst;
    for (const WandTrial& trial : trials) {
      worst.cameraPositionRms = std::max(worst.cameraPositionRms, trial.cameraPositionRms);
      worst.ballPositionRms = std::max(worst.ballPositionRms, trial.ballPositionRms);
      worst.clockOffsetError = std::max(worst.clockOffsetError, trial.clockOffsetError);
      worst.solveSeconds = std::max(worst.solveSeconds, trial.solveSeconds);
    }
    fmt::print("{}: {} of {} within {:.1f} mm; worst {:.2f} mm cameras, {:.2f} mm points, "
               "{:.2f} ms, {:.1f} s\n",
               wandCaseName(kind), std::ranges::count(trials, true, &WandTrial::hasPassed),
               trials.size(), inMillimeters(wandRmsLimit(kind)),
               inMillimeters(worst.cameraPositionRms), inMillimeters(worst.ballPositionRms),
               inMilliseconds(worst.clockOffsetError), worst.solveSeconds);
  }
  fmt::print("Seeds {}.\n", describeSeeds(first, seeds));
  return wasInterruptionRequested() ? kExitInterrupted : kExitDone;
}

void addWandStudy(CLI::App& group, int& exitCode) {
  struct Options {
    std::uint64_t first = kFirstReportingSeed;
    int seeds = 20;
    WandRecording recording;
  };
  auto* command = group.add_subcommand(
      "wand",
      "Measure the calibration from a rendered wand: accuracy, sensitivity to the start, speed.");
  auto options = std::make_shared<Options>();
  command->add_option("--seed", options->first, "The first seed")->capture_default_str();
  command->add_option("--seeds", options->seeds, "Number of seeds")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command
      ->add_option("--rate", options->recording.framesPerSecond, "Images per second of each camera")
      ->check(CLI::Range(5.0, 120.0))
      ->capture_default_str();
  command
      ->add_option("--jpeg", options->recording.jpegQuality,
                   "JPEG quality of the images, 1 to 100; 0: uncompressed")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  command->callback([options, &exitCode] {
    exitCode = studyWands(options->first, options->seeds, options->recording);
  });
}

} // namespace

void addExperimentCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand(
      "experiment", "Run an experiment from the papers, or one of Dewpoint's own.");
  command->require_subcommand(1);
  auto* convergence = command->add_subcommand(
      "convergence",
      "Method barrera: which starts converge, how fast they converge, and the drift.");
  auto options = std::make_shared<ConvergenceOptions>();
  convergence->add_option("--runs", options->runs, "Seeds per case")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  convergence->add_option("--seed", options->first, "The first seed")->capture_default_str();
  convergence->add_option("--out", options->folder,
                          "Folder for convergence.csv and drift.csv; created if it does not exist");
  convergence->callback([options, &exitCode] { exitCode = studyBarrera(*options); });
  addWandStudy(*command, exitCode);
  addFigureCommands(*command, exitCode);
  addPeopleExperiments(*command, exitCode);
  addSugandiExperiment(*command, exitCode);
  addFingerprintCommand(*command, exitCode);
  addSeedsCommand(*command, exitCode);
}

} // namespace dewpoint::app
