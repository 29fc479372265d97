// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "core/experiment/convergence_study.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace dewpoint {
namespace {

int studyBarrera(int runs) {
  fmt::print("{:<40} {:>10} {:>11} {:>9} {:>11}\n", "case", "converged", "iterations", "RMSE mm",
             "depth bias");
  for (const auto& setup : barreraConvergenceCases(runs)) {
    const auto result = studyConvergence(setup);
    if (!result) {
      return report(result.error());
    }
    fmt::print("{:<40} {:>4} / {:<3} {:>11.1f} {:>9.1f} {:>8.1f} mm\n", setup.name,
               result->converged, setup.runs, result->medianIterations, 1000.0 * result->rmse,
               1000.0 * result->depthBias);
    std::fflush(stdout);
  }
  const auto drift = measureDrift();
  if (!drift) {
    return report(drift.error());
  }
  fmt::print("drift away from a single camera: {:.1f} mm per iteration\n", 1000.0 * *drift);
  return kExitDone;
}

} // namespace

void addExperimentCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand("experiment", "Repeat an experiment of the papers.");
  command->require_subcommand(1);
  auto* convergence = command->add_subcommand(
      "convergence", "Method barrera: which starts converge, how fast, and the drift.");
  auto runs = std::make_shared<int>(100);
  convergence->add_option("--runs", *runs, "Seeds per case")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  convergence->callback([runs, &exitCode] { exitCode = studyBarrera(*runs); });
}

} // namespace dewpoint
