// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/token_file.h"
#include "app/dewpoint-cli/track/live_job.h"
#include "app/wiring/open_project.h"
#include "core/project/project_check.h"
#include "core/project/project_output.h"
#include "core/tracking/catalog/method_catalog.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace dewpoint::app {
namespace {

struct LiveOptions {
  std::string project;
  LiveJob job;
  int threads = 0;
  std::optional<std::string> osc;
  std::optional<std::string> tuio;
  std::optional<std::uint16_t> tcp;
  std::optional<std::uint16_t> websocket;
  std::optional<std::string> csv;
  std::optional<std::string> listen;
  std::optional<std::string> axes;
  std::optional<std::string> unit;
  std::optional<double> rate;
  std::string tokenFile;
};

/// Puts the value of an option in the place of the project's.
template <class Value>
void replace(LiveJob& job, const char* key, const std::optional<Value>& given, auto& value) {
  if (given) {
    value = *given;
    job.keysFromCommandLine.insert(key);
  }
}

/// The outputs of the project, and in their place those of the command line.
Status setOutput(LiveOptions& options, const Project& project) {
  LiveJob& job = options.job;
  OutputSettings& output = job.output = project.output;
  job.projectFile = project.file;
  replace(job, "osc", options.osc, output.oscReceiver);
  replace(job, "tuio", options.tuio, output.tuioReceiver);
  replace(job, "tcp", options.tcp, output.tcpPort);
  replace(job, "websocket", options.websocket, output.webSocketPort);
  replace(job, "csv", options.csv, output.csvFile);
  replace(job, "listen", options.listen, output.listenAddress);
  replace(job, "rate", options.rate, output.framesPerSecond);
  if (options.csv && *options.csv != "-") {
    output.csvFile = std::filesystem::absolute(*options.csv).string();
  }
  if (options.axes) {
    output.axes = *outputAxes(*options.axes);
  }
  if (options.unit) {
    output.unit = *outputUnit(*options.unit);
  }
  if (!options.tokenFile.empty()) {
    const auto token = readTokenFile(options.tokenFile);
    if (!token) {
      return tl::make_unexpected(token.error());
    }
    output.token = *token;
    job.keysFromCommandLine.insert("token");
  }
  return checkOutput(output).map_error(
      [&](Error error) { return job.withLocation(std::move(error)); });
}

int live(LiveOptions options) {
  auto project = resolveProject(options.project);
  if (!project) {
    return reportError(project.error());
  }
  if (const auto good = checkMethodTargets(*project); !good) {
    Error error = good.error();
    error.file = options.project;
    return reportError(error);
  }
  if (!methodFamily(project->method).writesPositions()) {
    return reportError(
        {ErrorCode::BadValue, options.project, "method",
         project->method + " tracks boxes in images, which have no position to send"});
  }
  if (const auto set = setOutput(options, *project); !set) {
    return reportError(set.error());
  }
  if (!options.job.output.isAnyOn() && !options.job.folder) {
    reportError({ErrorCode::MissingKey, options.project, "output",
                 "name at least one of --osc, --tuio, --tcp, --websocket, --csv and --out"});
    return kExitUsage;
  }
  auto inputs = openInputs(std::move(*project));
  if (!inputs) {
    return reportError(inputs.error());
  }
  inputs->threadCount = options.threads;
  return options.job.run(std::move(*inputs));
}

void addOutputOptions(CLI::App& command, LiveOptions& options) {
  constexpr std::uint16_t kLastPort = 65535;
  command.add_option("--osc", options.osc, "Send OSC messages by UDP to HOST:PORT");
  command.add_option("--tuio", options.tuio, "Send TUIO 1.1 3D cursors by UDP to HOST:PORT");
  command
      .add_option("--tcp", options.tcp,
                  "Send JSON lines to programs that connect to this port; 0: any free port")
      ->check(CLI::Range(std::uint16_t{0}, kLastPort));
  command
      .add_option("--websocket", options.websocket,
                  "Send JSON by WebSocket on this port, which also has a page; 0: any free port")
      ->check(CLI::Range(std::uint16_t{0}, kLastPort));
  command.add_option("--csv", options.csv,
                     "Write CSV lines to a file or a named pipe; - for standard output");
  command.add_option("--listen", options.listen,
                     "Address of this computer on which the ports are opened (default: the "
                     "project's, or 127.0.0.1: only this computer)");
  command.add_option("--axes", options.axes, "Axes of what is sent")
      ->check(CLI::IsMember({"z-up", "y-up", "y-up-left-handed"}));
  command.add_option("--unit", options.unit, "Unit of lengths in what is sent")
      ->check(CLI::IsMember({"m", "mm"}));
  command
      .add_option("--rate", options.rate,
                  "Send at most this number of frames per second; 0: all frames (default: the "
                  "project's, or 30)")
      ->check(CLI::Range(0.0, OutputSettings::kMaxFramesPerSecond));
  command.add_option("--token-file", options.tokenFile,
                     "Permit remote commands with the token in the first line of this file");
}

} // namespace

void addLiveCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand(
      "live", "Track a project in real time and send the results to other programs.");
  auto options = std::make_shared<LiveOptions>();
  command->add_option("PROJECT", options->project, "Project file (TOML), or a built-in scene: demo")
      ->required();
  command->add_option("--out", options->job.folder,
                      "Folder for the files that the command track also writes");
  command->add_option("--seconds", options->job.maxSeconds, "End after this time")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--threads", options->threads,
                   "Number of threads of the filter; does not change the result")
      ->check(CLI::Range(1, 256));
  addOutputOptions(*command, *options);
  command->callback([options, &exitCode] { exitCode = live(*options); });
}

} // namespace dewpoint::app
