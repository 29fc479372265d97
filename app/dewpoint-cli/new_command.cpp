// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "core/session/new_project.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace dewpoint {
namespace {

struct NewOptions {
  std::string file;
  std::vector<std::string> cameras;
  std::string calibration;
  bool force = false;
  NewProject project;
};

/// NAME=SOURCE, or a source alone; an address may hold "=" but no name does before "://".
NewCamera cameraFrom(const std::string& text) {
  const auto equals = text.find('=');
  const auto address = text.find("://");
  const bool named = equals != std::string::npos && equals < address && !text.starts_with("gst:");
  NewCamera camera;
  camera.name = named ? text.substr(0, equals) : "";
  camera.location = named ? text.substr(equals + 1) : text;
  camera.source = guessedSource(camera.location);
  return camera;
}

int makeNew(NewOptions& options) {
  if (std::filesystem::exists(options.file) && !options.force) {
    return report(
        {ErrorCode::FileUnwritable, options.file, "", "it exists already; --force replaces it"});
  }
  for (const std::string& camera : options.cameras) {
    options.project.cameras.push_back(cameraFrom(camera));
  }
  if (!options.calibration.empty()) {
    options.project.calibration = options.calibration;
  }
  const auto made = makeProject(options.project);
  if (!made) {
    return report(made.error());
  }
  if (const auto saved = saveProject(made->project, options.file); !saved) {
    return report(saved.error());
  }
  if (!made->calibrated) {
    fmt::print(stderr, "dewpoint-cli: note: without --calibration the camera positions are a "
                       "guess.\n");
  }
  if (made->matchedByOrder) {
    fmt::print(stderr, "dewpoint-cli: note: the calibration names its cameras differently; they "
                       "were taken in its order.\n");
  }
  fmt::print("{}\n", options.file);
  return kExitDone;
}

} // namespace

void addNewCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand("new", "Make a project of videos, image folders or cameras.");
  auto options = std::make_shared<NewOptions>();
  command->add_option("PROJECT", options->file, "Project file to write (TOML)")->required();
  command
      ->add_option(
          "--camera", options->cameras,
          "NAME=SOURCE, once per camera: a video, a folder of images, a device or a stream")
      ->required();
  command->add_option("--calibration", options->calibration,
                      "Calibration file; by the cameras' names, or else in its order");
  command->add_option("--name", options->project.name, "Name of the project");
  command->add_option("--rate", options->project.framesPerSecond, "Images per second of folders")
      ->check(CLI::Range(0.1, 10000.0));
  command->add_flag("--force", options->force, "Replace a file that exists");
  command->callback([options, &exitCode] { exitCode = makeNew(*options); });
}

} // namespace dewpoint
