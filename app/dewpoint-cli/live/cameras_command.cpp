// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/wiring/open_project.h"
#include "core/capture/devices/color_lock.h"
#include "core/capture/devices/device_match.h"
#include "core/capture/gstreamer/open_live.h"
#include "core/capture/image_health.h"
#include "core/project/project_load.h"
#include "core/project/project_save.h"
#include "core/setup/device_list.h"
#include "core/setup/new_project/new_project.h"
#include "core/setup/new_project/project_devices.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::app {
namespace {

using LockClock = std::chrono::steady_clock;

struct ListOptions {
  bool controls = false;
  bool asJson = false;
};

struct LockOptions {
  std::string project;
  std::vector<std::string> cameras;
  std::string out;
  double seconds = 3.0;
};

int printDevices(const ListOptions& options) {
  const DeviceAccessPtr access = systemDevices();
  std::vector<ListedDevice> devices;
  for (CameraDevice& device : access->listDevices()) {
    ListedDevice& listed = devices.emplace_back();
    if (options.controls && device.problem.empty()) {
      auto controls = access->readControls(device.path);
      if (!controls) {
        return reportError(controls.error());
      }
      listed.controls = std::move(*controls);
    }
    listed.device = std::move(device);
  }
  if (options.asJson) {
    fmt::print("{}\n", deviceListJson(devices));
  } else if (devices.empty()) {
    fmt::print(stderr, "dewpoint-cli: note: no camera is connected.\n");
  } else {
    fmt::print("{}", deviceListText(devices));
  }
  return kExitDone;
}

const char* automaticName(ColorAutomatic automatic) {
  switch (automatic) {
  case ColorAutomatic::Exposure:
    return "exposure";
  case ColorAutomatic::Gain:
    return "gain";
  case ColorAutomatic::WhiteBalance:
    return "white balance";
  case ColorAutomatic::Hue:
    return "hue";
  }
  return "";
}

/// Indices of the cameras to lock: those named, or all that have a device.
Result<std::vector<std::size_t>> camerasToLock(const LockOptions& options, const Project& project) {
  const auto isDevice = [](const ProjectCamera& camera) {
    return camera.source == SourceKind::Device;
  };
  std::vector<std::size_t> cameras;
  for (std::size_t k = 0; options.cameras.empty() && k < project.cameras.size(); ++k) {
    if (isDevice(project.cameras[k])) {
      cameras.push_back(k);
    }
  }
  for (const std::string& name : options.cameras) {
    const auto found = std::ranges::find_if(
        project.cameras, [&](const ProjectCamera& camera) { return camera.camera.name == name; });
    if (found == project.cameras.end() || !isDevice(*found)) {
      return failure(ErrorCode::BadValue, options.project, "camera",
                     fmt::format("no camera with a device is called '{}'", name));
    }
    const auto index = static_cast<std::size_t>(found - project.cameras.begin());
    if (std::ranges::find(cameras, index) == cameras.end()) { // named once
      cameras.push_back(index);
    }
  }
  if (cameras.empty()) {
    return failure(ErrorCode::Mismatch, options.project, "camera", "no camera has a device");
  }
  return cameras;
}

/// Paths of the devices of these cameras, which get their identities.
Result<std::vector<std::string>> devicePaths(Project& project, const std::string& file,
                                             const std::vector<std::size_t>& cameras,
                                             const std::vector<CameraDevice>& devices) {
  identifyDevices(project, devices);
  const auto matches = matchProjectDevices(project, devices);
  std::vector<std::string> paths;
  for (const std::size_t k : cameras) {
    const ProjectCamera& camera = project.cameras[k];
    if (!matches[k].deviceIndex) {
      const bool isKnown = !camera.device.identity.isEmpty();
      return failure(ErrorCode::DeviceUnavailable, file,
                     fmt::format("camera '{}'", camera.camera.name),
                     isKnown ? mismatchReason(matches[k], camera.device.identity, devices)
                             : "no camera is connected at " + camera.location);
    }
    paths.push_back(devices[*matches[k].deviceIndex].path);
  }
  return paths;
}

/// Opens the cameras and lets their automatics adjust. They go on as long as the source lives.
Result<std::unique_ptr<FrameSetSource>>
runningCameras(const Project& project, const std::vector<std::size_t>& cameras, double seconds) {
  const std::vector<LiveCamera> all = liveCamerasOf(project);
  std::vector<LiveCamera> chosen;
  for (const std::size_t k : cameras) {
    chosen.push_back(all[k]);
    chosen.back().device.controls.clear(); // the automatics stay as they are
    chosen.back().width = chosen.back().height = 0;
  }
  auto source = openLive(chosen);
  if (!source) {
    return source;
  }
  const auto end = LockClock::now() + std::chrono::duration<double>(seconds);
  while (LockClock::now() < end && !wasInterruptionRequested()) {
    if (const auto next = (*source)->next(); !next) {
      return tl::make_unexpected(next.error());
    }
  }
  const auto notices = (*source)->notices();
  const auto failed =
      std::ranges::find_if(notices, [](const Error& notice) { return !isImageFault(notice.code); });
  if (failed != notices.end()) {
    return tl::make_unexpected(*failed);
  }
  return source;
}

/// Prints what was set; returns whether everything could be.
bool printLock(const std::string& camera, const ColorLock& lock) {
  for (const auto& [name, value] : lock.values) {
    fmt::print("{}: {} = {}\n", camera, name, value);
  }
  for (const ColorLock::Refusal& refusal : lock.refusals) {
    fmt::print(stderr, "dewpoint-cli: camera '{}': the automatic {} is not locked: {}: {}.\n",
               camera, automaticName(refusal.adjustment), refusal.controlName, refusal.reason);
  }
  for (const ColorAutomatic automatic : lock.missingControls) {
    fmt::print(stderr, "dewpoint-cli: note: camera '{}' has no control for its {}.\n", camera,
               automaticName(automatic));
  }
  return lock.refusals.empty();
}

int lockCameras(const LockOptions& options) {
  auto project = loadProject(options.project);
  if (!project) {
    return reportError(project.error());
  }
  const auto cameras = camerasToLock(options, *project);
  if (!cameras) {
    return reportError(cameras.error());
  }
  const DeviceAccessPtr access = systemDevices();
  const auto paths = devicePaths(*project, options.project, *cameras, access->listDevices());
  if (!paths) {
    return reportError(paths.error());
  }
  if (const auto guessed = guessMissingCameras(*project); !guessed) {
    return reportError(guessed.error());
  }
  catchInterruption();
  const auto running = runningCameras(*project, *cameras, options.seconds);
  if (!running) {
    return reportError(running.error());
  }
  if (wasInterruptionRequested()) {
    return kExitInterrupted;
  }
  bool isComplete = true;
  for (std::size_t i = 0; i < cameras->size(); ++i) {
    ProjectCamera& camera = project->cameras[(*cameras)[i]];
    const auto locked = lockColors(*access, (*paths)[i]);
    if (!locked) {
      return reportError(locked.error());
    }
    for (const auto& [name, value] : locked->values) {
      camera.device.controls[name] = value;
    }
    isComplete = printLock(camera.camera.name, *locked) && isComplete;
  }
  const std::string& file = options.out.empty() ? options.project : options.out;
  if (const auto saved = saveProject(*project, file); !saved) {
    return reportError(saved.error());
  }
  return isComplete ? kExitDone : kExitProblems;
}

void addLockCommand(CLI::App& group, int& exitCode) {
  auto* command = group.add_subcommand(
      "lock", "Switch automatic exposure, gain and white balance of a project's cameras off at "
              "their present values, and keep the values in the project.");
  auto options = std::make_shared<LockOptions>();
  command->add_option("PROJECT", options->project, "Project file (TOML) with devices")->required();
  command->add_option("CAMERA", options->cameras, "Names of cameras (default: all with a device)");
  command->add_option("--out", options->out, "Project file to write instead of PROJECT");
  command
      ->add_option("--seconds", options->seconds,
                   "How long the cameras run before, so that they adjust to the light")
      ->check(CLI::Range(0.1, 600.0))
      ->capture_default_str();
  command->callback([options, &exitCode] { exitCode = lockCameras(*options); });
}

} // namespace

void addCamerasCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand(
      "cameras", "List the cameras that are connected to this computer, and lock their colors.");
  command->require_subcommand(0, 1);
  auto options = std::make_shared<ListOptions>();
  command->add_flag("--controls", options->controls,
                    "Also list the controls of each camera, with their ranges and present values");
  command->add_flag("--json", options->asJson, "Print a JSON array");
  addLockCommand(*command, exitCode);
  command->callback([command, options, &exitCode] {
    if (command->get_subcommands().empty()) {
      exitCode = printDevices(*options);
    }
  });
}

} // namespace dewpoint::app
