// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_save.h"

#include "core/base/table_reader.h"
#include "core/base/text_file.h"
#include "core/calibration/formats/camera_calibration.h"
#include "core/project/project_comments.h"
#include "core/project/project_corrections.h"
#include "core/project/project_devices.h"
#include "core/project/project_format.h"
#include "core/project/project_output.h"
#include "core/project/project_people.h"
#include "core/project/project_records.h"
#include "core/project/project_room.h"
#include "core/project/project_targets.h"

#include <array>
#include <string_view>

namespace dewpoint::project {
namespace {

using std::filesystem::path;

/// Relative where the file lies below the project's folder, so that the folder can be moved.
std::string storedPath(const path& file, const path& folder) {
  const path relative = file.lexically_relative(folder);
  const bool below = !relative.empty() && *relative.begin() != "..";
  return tomlQuoted((below ? relative : file).string());
}

std::string cameraText(const ProjectCamera& camera, const path& folder) {
  std::string text = "\n[[camera]]\nname = " + tomlQuoted(camera.camera.name) + "\n";
  for (const auto& [key, kind] : kSourceKeys) {
    if (kind == camera.source) {
      const bool isFile = kind == SourceKind::Video || kind == SourceKind::Images;
      text +=
          fmt::format("{} = {}\n", key,
                      isFile ? storedPath(camera.location, folder) : tomlQuoted(camera.location));
    }
  }
  const bool isDevice = camera.source == SourceKind::Device;
  text += isDevice ? deviceFormatText(camera.device.format) : "";
  if (camera.rotateDegrees != 0) {
    text += fmt::format("rotate = {}   # degrees clockwise\n", camera.rotateDegrees);
  }
  if (camera.isMirrored) {
    text += "mirror = true   # left to right, after the rotation\n";
  }
  if (const ImageMargins& crop = camera.crop; !crop.isZeroOnAllSides()) {
    text += fmt::format("crop = [{}, {}, {}, {}]   # pixels cut off: left, top, right, bottom\n",
                        crop.left, crop.top, crop.right, crop.bottom);
  }
  if (camera.delay != 0.0) {
    text += fmt::format("late_by = {}   # delay of its images in seconds\n", camera.delay);
  }
  if (!camera.captureTimeFile.empty()) {
    text += "times = " + storedPath(camera.captureTimeFile, folder) +
            "   # when each image was taken\n";
  }
  if (!camera.backgroundImageFile.empty()) {
    text += "empty_room = " + storedPath(camera.backgroundImageFile, folder) + "\n";
  }
  return text + "[camera.calibration]   # pixels, radians, meters; camera from world\n" +
         cameraToToml(camera.camera, RotationForm::Matrix) +
         cameraRecordText(camera.calibrationRecord) +
         (isDevice ? deviceTablesText(camera.device) : "");
}

std::string parametersText(const ParameterValues& parameters) {
  std::string text = "\n[parameters]\n";
  for (const auto& declaration : parameters.declarations()) {
    if (!parameters.isGiven(declaration.key)) {
      continue; // the cameras will tell
    }
    const double value = parameters.at(declaration.key);
    text += declaration.kind == ParameterKind::Integer
                ? fmt::format("{} = {}", declaration.key, static_cast<std::int64_t>(value))
                : fmt::format("{} = {}", declaration.key, value);
    text += declaration.unit.empty() ? "\n" : fmt::format("   # {}\n", declaration.unit);
  }
  return text;
}

/// A file with the comments that earlier versions wrote ("metres") as they are written now: else
/// they would pass for a person's, and stay beside the present ones.
std::string withUpdatedComments(std::string text) {
  constexpr std::array<std::string_view, 3> kPresent{
      "# Dewpoint project: meters, seconds, radians, pixels; Z is up\n", "# meters, radians\n",
      "# pixels, radians, meters; camera from world\n"};
  for (const std::string_view present : kPresent) {
    std::string former(present);
    former.replace(former.find("meters"), 6, "metres");
    for (auto at = text.find(former); at != std::string::npos; at = text.find(former, at)) {
      text.replace(at, former.size(), present);
    }
  }
  return text;
}

} // namespace

std::string projectText(const Project& project, const std::filesystem::path& folder) {
  std::string text = fmt::format("# Dewpoint project: meters, seconds, radians, pixels; Z is up\n"
                                 "format = {}\nname = {}\nmethod = {}\nseed = {}\n",
                                 kProjectFormat, tomlQuoted(project.name),
                                 tomlQuoted(project.method), project.seed);
  if (project.framesPerSecond > 0.0 && project.scene.empty()) {
    text += fmt::format("frames_per_second = {}\n", project.framesPerSecond);
  }
  if (project.truthFile) {
    text += "truth = " + storedPath(*project.truthFile, folder) + "\n";
  }
  if (!project.scene.empty()) {
    text += "scene = " +
            (project.scene.ends_with(".toml") ? storedPath(project.scene, folder)
                                              : tomlQuoted(project.scene)) +
            "\n";
  }
  text += parametersText(project.parameters);
  for (const auto& target : project.targets) {
    text += targetText(target);
  }
  for (const auto& camera : project.cameras) {
    if (camera.source != SourceKind::Simulation || camera.hasOwnCalibration) {
      text += cameraText(camera, folder);
    }
  }
  for (const auto& marker : project.markers) {
    text +=
        fmt::format("\n[[mark]]\nframe = {}\nname = {}\n", marker.frame, tomlQuoted(marker.name));
  }
  text += roomText(project);
  text += worldRecordText(project.worldRecord);
  text += peopleText(project);
  text += correctionsText(project);
  text += outputText(project.output);
  if (!project.windowLayout.empty()) {
    text +=
        "\n[window]   # how its views were laid out\nlayout = " + tomlQuoted(project.windowLayout) +
        "\n";
  }
  return text;
}

Status saveProject(const Project& project, const std::filesystem::path& file) {
  const std::string text = projectText(project, std::filesystem::absolute(file).parent_path());
  // Comments a person wrote into the file that the project comes from go along.
  const auto former = readTextFile(project.file);
  return writeTextFile(file, former ? withComments(text, withUpdatedComments(*former)) : text);
}

} // namespace dewpoint::project
