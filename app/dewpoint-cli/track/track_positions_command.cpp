// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "core/session/run/track_positions.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/trajectory/trajectory_reader.h"
#include "core/trajectory/trajectory_writer.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace dewpoint::app {
namespace {

struct TrackPositionsOptions {
  std::string measured;
  std::string out;
  std::uint64_t seed = 1;
  double rate = kPositionsPerSecond;
  std::vector<std::string> settings;
};

Status writeTrajectory(const Trajectory& trajectory, const std::string& file) {
  auto writer = TrajectoryWriter::create(file, trajectory.header);
  if (!writer) {
    return tl::make_unexpected(writer.error());
  }
  for (const TrajectorySample& sample : trajectory.samples) {
    if (auto written = writer->write(sample); !written) {
      return written;
    }
  }
  return writer->finish();
}

int trackPositionsIn(const TrackPositionsOptions& options) {
  ParameterValues parameters(methodParameters("dynamics"));
  for (const std::string& setting : options.settings) {
    const auto equals = setting.find('=');
    const std::string value = equals == std::string::npos ? "" : setting.substr(equals + 1);
    if (isStartPositionParameter(setting.substr(0, equals))) {
      reportError({ErrorCode::BadValue, "", "--set " + setting.substr(0, equals),
                   "the filter of each target starts at its first position"});
      return kExitUsage;
    }
    if (const auto set = parameters.setFromText(setting.substr(0, equals), value); !set) {
      reportError(set.error());
      return kExitUsage;
    }
  }
  auto measured = readTrajectory(options.measured);
  if (!measured) {
    return reportError(measured.error());
  }
  const auto reportInput = [&](Error error) {
    error.file = options.measured;
    return reportError(error);
  };
  const auto timed = addMissingTimes(*measured, options.rate);
  if (!timed) {
    return reportInput(timed.error());
  }
  auto tracked = trackPositions(*measured, parameters, options.seed);
  if (!tracked) {
    return reportInput(tracked.error());
  }
  if (tracked->samples.empty()) {
    return reportInput({ErrorCode::BadValue, "", "x_m", "it contains no position"});
  }
  if (*timed) {
    tracked->header.entries.emplace_back("times",
                                         fmt::format("frames at {:g} per second", options.rate));
  }
  if (const auto written = writeTrajectory(*tracked, options.out); !written) {
    return reportError(written.error());
  }
  fmt::print("{} rows in {}{}.\n", tracked->samples.size(), options.out,
             *timed ? fmt::format(", times from the frames at {:g} per second", options.rate)
                    : std::string());
  return kExitDone;
}

} // namespace

void addTrackPositionsCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand(
      "track-positions", "Track measured 3D positions with method dynamics, without images.");
  auto options = std::make_shared<TrackPositionsOptions>();
  command
      ->add_option("MEASURED", options->measured,
                   "CSV with frame or time_s, x_m, y_m, z_m; target if there are several")
      ->required();
  command->add_option("--out", options->out, "Trajectory (CSV) to write")->required();
  command->add_option("--seed", options->seed, "Seed of the run")->capture_default_str();
  command
      ->add_option(
          "--rate", options->rate,
          "Frames per second, to compute times for a file that contains only frame numbers")
      ->check(CLI::Range(0.001, 100000.0))
      ->capture_default_str();
  command->add_option("--set", options->settings, "Set a parameter of the method: key=value");
  command->callback([options, &exitCode] { exitCode = trackPositionsIn(*options); });
}

} // namespace dewpoint::app
