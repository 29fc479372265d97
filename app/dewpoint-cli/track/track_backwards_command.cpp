// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/common/progress.h"
#include "app/wiring/open_project.h"
#include "core/project/project_save.h"
#include "core/session/run/backward_track.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>

namespace dewpoint::app {
namespace {

struct TrackBackwardsOptions {
  std::string project;
  std::string out;
  int threads = 1;
};

/// What was found for each correction by a person.
void printFound(const Project& before, const Project& after) {
  for (const PositionCorrection& said : before.corrections) {
    if (said.trackedFrom) {
      continue;
    }
    const auto first = std::ranges::find_if(after.corrections, [&](const PositionCorrection& one) {
      return one.target == said.target && one.trackedFrom == said.frame;
    });
    const std::string& name = after.targets.at(static_cast<std::size_t>(said.target)).name;
    fmt::print("{}, frame {}: {}.\n", name, said.frame,
               first == after.corrections.end()
                   ? "the earlier estimate was right"
                   : fmt::format("followed back to frame {}", first->frame));
  }
}

int trackBackwardsIn(const TrackBackwardsOptions& options) {
  auto project = resolveProject(options.project);
  if (!project) {
    return reportError(project.error());
  }
  const auto fail = [&](Error error) {
    error.file = error.file.empty() ? options.project : error.file;
    return reportError(error);
  };
  if (std::ranges::none_of(project->corrections,
                           [](const PositionCorrection& one) { return !one.trackedFrom; })) {
    return fail({ErrorCode::MissingKey, "", "correction",
                 "the project has no correction that gives a target's position"});
  }
  auto inputs = openInputs(std::move(*project));
  if (!inputs) {
    return fail(inputs.error());
  }
  if (inputs->source->isLive()) {
    return fail({ErrorCode::BadValue, "", "camera", "live cameras cannot be tracked backward"});
  }
  catchInterruption();
  constexpr std::int64_t kSteps = 1000;
  Progress progress("tracking backwards", kSteps);
  const auto found =
      withBackwardCorrections(inputs->project, *inputs->source, inputs->backgroundImages,
                              options.threads, [&](double part) {
                                progress.show(static_cast<std::int64_t>(part * kSteps));
                                return !wasInterruptionRequested();
                              });
  progress.finish();
  if (!found) {
    return found.error().code == ErrorCode::Canceled ? static_cast<int>(kExitInterrupted)
                                                     : fail(found.error());
  }
  printFound(inputs->project, *found);
  const auto saved = saveProject(*found, options.out);
  return saved ? static_cast<int>(kExitDone) : reportError(saved.error());
}

} // namespace

void addTrackBackwardsCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand("track-backwards",
                                     "Track targets backward from the corrections of a project.");
  auto options = std::make_shared<TrackBackwardsOptions>();
  command->add_option("PROJECT", options->project, "Project file (TOML) with corrections")
      ->required();
  command->add_option("--out", options->out, "Project file to write, with the new corrections")
      ->required();
  command
      ->add_option("--threads", options->threads,
                   "Number of threads of the filter; does not change the result")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->callback([options, &exitCode] { exitCode = trackBackwardsIn(*options); });
}

} // namespace dewpoint::app
