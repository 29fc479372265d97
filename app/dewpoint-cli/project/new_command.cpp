// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/wiring/open_project.h"
#include "core/camera_motion/agreement/disagreement_sentence.h"
#include "core/capture/devices/device_access.h"
#include "core/project/project_rig.h"
#include "core/project/project_save.h"
#include "core/session/run/background_images.h"
#include "core/setup/device_list.h"
#include "core/setup/new_project/footage.h"
#include "core/setup/new_project/new_project.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

namespace dewpoint::app {
namespace {

struct NewOptions {
  std::string file;
  std::vector<std::string> cameras;
  std::string footage;
  bool connected = false;
  std::string calibration;
  std::string fit;
  std::vector<std::string> names;
  std::vector<std::string> backgroundImages;
  std::string times;
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
  camera.sourceKind = guessSourceKind(camera.location);
  return camera;
}

/// NAME=FILE into the camera of that name; then they are all read, so that what is wrong is said
/// now.
Status addBackgroundImages(const std::vector<std::string>& texts, Project& project) {
  for (const std::string& text : texts) {
    const auto equals = text.find('=');
    const auto camera = std::ranges::find_if(project.cameras, [&](const ProjectCamera& one) {
      return equals != std::string::npos && one.camera.name == text.substr(0, equals);
    });
    if (camera == project.cameras.end()) {
      return failure(ErrorCode::BadValue, "", "--empty-room",
                     "'" + text + "' does not begin with the name of a camera and '='");
    }
    camera->backgroundImageFile =
        std::filesystem::absolute(text.substr(equals + 1)).lexically_normal().string();
  }
  return loadBackgroundImages(project).map([](const auto&) {});
}

/// The cameras that were named, then those of a folder, then those that are connected.
Result<std::vector<NewCamera>> camerasOf(const NewOptions& options) {
  std::vector<NewCamera> cameras;
  for (const std::string& text : options.cameras) {
    cameras.push_back(cameraFrom(text));
  }
  std::vector<std::string> found;
  if (!options.footage.empty()) {
    found = footageIn(options.footage);
    if (found.empty()) {
      return failure(ErrorCode::FileMissing, options.footage, "--footage",
                     "it contains no video and no image folder");
    }
  }
  if (options.connected) {
    const auto devices = connectedCameras();
    if (devices.empty()) {
      return failure(ErrorCode::FileMissing, "", "--connected", "no camera is connected");
    }
    found.insert(found.end(), devices.begin(), devices.end());
  }
  for (const std::string& location : found) {
    cameras.push_back({"", guessSourceKind(location), location});
  }
  if (cameras.empty()) {
    return failure(ErrorCode::MissingKey, "", "--camera",
                   "name at least one camera with --camera, --footage or --connected");
  }
  return cameras;
}

int makeNew(NewOptions& options) {
  if (std::filesystem::exists(options.file) && !options.force) {
    return reportError({ErrorCode::FileUnwritable, options.file, "",
                        "it already exists; use --force to replace it"});
  }
  auto cameras = camerasOf(options);
  if (!cameras) {
    const bool missing = cameras.error().code == ErrorCode::MissingKey;
    const int code = reportError(cameras.error());
    return missing ? static_cast<int>(kExitUsage) : code;
  }
  for (NewCamera& camera : *cameras) {
    const auto& others = options.project.cameras;
    if (!camera.name.empty() &&
        std::ranges::find(others, camera.name, &NewCamera::name) != others.end()) {
      reportError({ErrorCode::BadValue, "", "--camera",
                   fmt::format("two cameras are called '{}'", camera.name)});
      return kExitUsage;
    }
    options.project.cameras.push_back(std::move(camera));
  }
  if (!options.calibration.empty()) {
    options.project.calibrationFile = options.calibration;
  }
  auto names = parseCameraRenaming(options.names);
  if (!names) {
    reportError(names.error());
    return kExitUsage;
  }
  options.project.adaptation = {std::move(*names), parseSizeFit(options.fit)};
  auto made = createNewProject(options.project);
  if (!made) {
    return reportError(made.error());
  }
  identifyDevices(made->project, systemDevices()->listDevices());
  if (const auto added = addBackgroundImages(options.backgroundImages, made->project); !added) {
    return reportError(added.error());
  }
  if (!options.times.empty()) {
    for (ProjectCamera& camera : made->project.cameras) {
      camera.captureTimeFile = std::filesystem::absolute(options.times).lexically_normal().string();
    }
    if (const auto opened = openInputs(made->project); !opened) { // what is wrong is said now
      return reportError(opened.error());
    }
  }
  // A folder that is missing is made; if it cannot be, writing says why.
  std::error_code problem;
  std::filesystem::create_directories(std::filesystem::absolute(options.file).parent_path(),
                                      problem);
  if (const auto saved = saveProject(made->project, options.file); !saved) {
    return reportError(saved.error());
  }
  if (made->lacksCalibration) {
    fmt::print(stderr,
               "dewpoint-cli: note: without --calibration, the camera positions are guesses.\n");
  }
  if (made->wereCamerasMatchedByOrder) {
    fmt::print(stderr, "dewpoint-cli: note: the calibration uses other camera names; the cameras "
                       "were matched by order.\n");
  }
  for (const std::string& decision : made->decisions) {
    fmt::print(stderr, "dewpoint-cli: note: {}\n", decision);
  }
  for (const CameraDisagreement& fault : made->likelyMistakes) {
    fmt::print(stderr, "dewpoint-cli: note: {}.\n",
               describeDisagreement(fault, rigOf(made->project)));
  }
  fmt::print("{}\n", options.file);
  return kExitDone;
}

} // namespace

void addNewCommand(CLI::App& app, int& exitCode) {
  auto* command =
      app.add_subcommand("new", "Create a project from videos, image folders or cameras.");
  auto options = std::make_shared<NewOptions>();
  command->add_option("PROJECT", options->file, "Project file to write (TOML)")->required();
  command->add_option("--camera", options->cameras,
                      "NAME=SOURCE: name of a camera and its video, folder of images, device or "
                      "stream; repeat for each camera");
  command->add_option("--footage", options->footage,
                      "Folder; each video and each image folder in it becomes a camera, sorted by "
                      "name (camera 2 before camera 10)");
  command->add_flag("--connected", options->connected,
                    "All cameras that are connected to this computer");
  command->add_option(
      "--calibration", options->calibration,
      "Calibration file; cameras are matched by name, or by order if the names differ");
  command
      ->add_option("--map", options->names,
                   "NAME=NAME IN THE FILE: name of a camera in the project and its name in the "
                   "calibration file; repeat for each camera")
      ->allow_extra_args(false)
      ->needs("--calibration");
  command
      ->add_option("--fit", options->fit,
                   "How the images were changed if their size differs from that of the "
                   "calibration: cropped on all sides, trimmed at the right and below, scaled, or "
                   "rotated clockwise by 90 or 270 degrees")
      ->check(CLI::IsMember({"crop", "trim", "scale", "rotate-90", "rotate-270"}))
      ->needs("--calibration");
  command->add_option("--empty-room", options->backgroundImages,
                      "NAME=FILE: name of a camera, and an image, video or folder of images in "
                      "which this camera shows the scene without any target");
  command->add_option("--times", options->times,
                      "Table (CSV) with the times at which the images of each camera were taken");
  command->add_option("--name", options->project.name, "Name of the project");
  command
      ->add_option("--rate", options->project.framesPerSecond,
                   "Images per second, for folders of images")
      ->check(CLI::Range(0.1, 10000.0));
  command->add_flag("--force", options->force, "Replace an existing file");
  command->callback([options, &exitCode] { exitCode = makeNew(*options); });
}

} // namespace dewpoint::app
