// SPDX-License-Identifier: GPL-3.0-or-later
// The papers' figures, one command each.
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/common/progress.h"
#include "app/dewpoint-cli/experiment/experiment_commands.h"
#include "core/base/units.h"
#include "core/experiment/studies/figure_experiments.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <string>

namespace dewpoint::app {
namespace {

int makeFigure(const FigureExperiment& experiment, ExperimentOptions options) {
  catchInterruption();
  Progress bar(std::string(experiment.name), 100);
  options.runCount = options.runCount > 0 ? options.runCount : experiment.runCount;
  options.progress = [&](double part) {
    bar.show(static_cast<std::int64_t>(inPercent(part)));
    return !wasInterruptionRequested();
  };
  const auto made = experiment.run(options);
  bar.finish();
  if (!made) {
    return made.error().code == ErrorCode::Canceled ? static_cast<int>(kExitInterrupted)
                                                    : reportError(made.error());
  }
  fmt::print("{}\n", (options.outputFolder / "report.html").string());
  return kExitDone;
}

} // namespace

void addFigureCommands(CLI::App& group, int& exitCode) {
  for (const FigureExperiment& experiment : figureExperiments()) {
    auto* command =
        group.add_subcommand(std::string(experiment.name), std::string(experiment.description));
    auto options = std::make_shared<ExperimentOptions>();
    command
        ->add_option_function<std::string>(
            "--out", [options](const std::string& folder) { options->outputFolder = folder; },
            "Folder for report.html, its pictures and numbers; created if it does not exist")
        ->required();
    command->add_option("--runs", options->runCount, "Seeds per case")->check(CLI::Range(1, 10000));
    command->add_option("--seed", options->firstSeed, "The first seed")->capture_default_str();
    command->callback(
        [&experiment, options, &exitCode] { exitCode = makeFigure(experiment, *options); });
  }
}

} // namespace dewpoint::app
