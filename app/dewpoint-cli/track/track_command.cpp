// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/frame_range.h"
#include "app/dewpoint-cli/common/parameter_settings.h"
#include "app/dewpoint-cli/common/repeated_job.h"
#include "app/dewpoint-cli/track/track_job.h"
#include "app/wiring/open_project.h"
#include "core/project/project_check.h"
#include "core/tracking/catalog/method_catalog.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <optional>

namespace dewpoint::app {
namespace {

struct TrackOptions {
  std::string project;
  TrackJob job;
  JobOptions repeated;
  std::optional<std::string> method;
  std::optional<std::uint64_t> seed;
  std::optional<std::int64_t> particles;
  std::string frames;
  std::string volume;
  std::vector<std::string> settings;
};

/// Whether the tables of a method are those of people, which another command writes.
bool isForPeople(const std::string& method) {
  return methodFamily(method).writesBodies();
}

/// Of all methods those of which the command writes the tables.
std::vector<std::string> trackableMethods() {
  std::vector<std::string> names = methodNames();
  std::erase_if(names, isForPeople);
  return names;
}

/// Whether the project of `file` names what its method is to follow.
Status checkTargets(const Project& project, const std::string& file) {
  if (isForPeople(project.method)) {
    return failure(ErrorCode::BadValue, file, "method",
                   project.method + " is a method for people; use dewpoint-cli people");
  }
  return checkMethodTargets(project).map_error([&](Error error) {
    error.file = file;
    return error;
  });
}

/// The box whose corners are `x0,y0,z0,x1,y1,z1`.
Result<WorldBox> parseVolume(const std::string& text) {
  WorldBox box;
  int used = 0;
  const int read = std::sscanf(text.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf%n", &box.min[0], &box.min[1],
                               &box.min[2], &box.max[0], &box.max[1], &box.max[2], &used);
  if (read != 6 || static_cast<std::size_t>(used) != text.size() || !box.min.allFinite() ||
      !box.max.allFinite() || (box.min.array() >= box.max.array()).any()) {
    return failure(ErrorCode::BadValue, "", "--volume",
                   text + " is not x0,y0,z0,x1,y1,z1 in meters, with each of the last three "
                          "greater than its counterpart");
  }
  return box;
}

Status applyOptions(const TrackOptions& options, Project& project) {
  if (!options.volume.empty()) {
    const auto volume = parseVolume(options.volume);
    if (!volume) {
      return tl::make_unexpected(volume.error());
    }
    project.volumeOfInterest = *volume;
  }
  if (options.method && *options.method != project.method) {
    project.method = *options.method;
    project.parameters = carryOverParameters(project.parameters, project.method);
  }
  project.seed = options.seed.value_or(project.seed);
  if (options.particles) {
    if (const auto set =
            project.parameters.set("particles", static_cast<double>(*options.particles));
        !set) {
      return set;
    }
  }
  return applySettings(options.settings, project.parameters);
}

int track(TrackOptions options) {
  auto project = resolveProject(options.project);
  if (!project) {
    return reportError(project.error());
  }
  const auto frames = parseFrames(options.frames);
  if (!frames) {
    reportError(frames.error());
    return kExitUsage;
  }
  options.job.frames = *frames;
  if (const auto applied = applyOptions(options, *project); !applied) {
    reportError(applied.error());
    return kExitUsage;
  }
  if (const auto good = checkTargets(*project, options.project); !good) {
    return reportError(good.error());
  }
  const std::string& label =
      options.repeated.label.empty() ? options.project : options.repeated.label;
  auto planned = makeJobRecord("track", *project, label, options.frames,
                               options.job.writesReasonsFile ? "with reasons" : "");
  if (isAlreadyDone(options.job.folder, planned, options.repeated)) {
    return kExitDone;
  }
  options.job.record = std::move(planned);
  auto inputs = openInputs(std::move(*project));
  if (!inputs) {
    return reportError(inputs.error());
  }
  return options.job.run(std::move(*inputs));
}

} // namespace

void addTrackCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand(
      "track", "Track a project's targets and write trajectory.csv and run.json.");
  auto options = std::make_shared<TrackOptions>();
  command->add_option("PROJECT", options->project, "Project file (TOML), or a built-in scene: demo")
      ->required();
  command->add_option("--out", options->job.folder, "Folder to write")->required();
  command->add_option("--method", options->method, "Tracking method")
      ->check(CLI::IsMember(trackableMethods()));
  command->add_option("--seed", options->seed, "Seed of the run (default: the project's)");
  command
      ->add_option("--threads", options->job.threadCount,
                   "Number of threads of the filter; does not change the result")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_option("--frames", options->frames,
                      "Only frames A to B-1, as A:B (either may be empty)");
  command->add_option("--particles", options->particles, "Number of particles");
  command->add_flag("--reasons", options->job.writesReasonsFile,
                    "Also write reasons.csv: when and why targets were tracked or not");
  command->add_option(
      "--volume", options->volume,
      "Track only in this box, as x0,y0,z0,x1,y1,z1 in meters (default: the project's)");
  command->add_option("--set", options->settings, "Set a parameter of the method: key=value");
  addJobOptions(*command, options->repeated);
  command->callback([options, &exitCode] { exitCode = track(*options); });
}

} // namespace dewpoint::app
