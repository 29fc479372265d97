// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_files.h"

#include "core/project/project_save.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::project {
namespace {

/// The folder of a project file; empty of a project without one, as that of a built-in scene.
std::filesystem::path folderOf(const Project& project) {
  return project.file.empty() ? project.file
                              : std::filesystem::absolute(project.file).parent_path();
}

} // namespace

std::vector<ProjectFile> runInputFiles(const Project& project) {
  const std::filesystem::path folder = folderOf(project);
  std::vector<ProjectFile> files;
  const auto add = [&](const std::filesystem::path& path) {
    const auto relative = path.lexically_relative(folder);
    const bool isBelow = !relative.empty() && *relative.begin() != "..";
    files.push_back({(isBelow ? relative : path).generic_string(), path});
  };
  for (const ProjectCamera& camera : project.cameras) {
    if (camera.source == SourceKind::Video || camera.source == SourceKind::Images) {
      add(camera.location);
    }
    for (const std::string& file : {camera.captureTimeFile, camera.backgroundImageFile}) {
      if (!file.empty()) {
        add(file);
      }
    }
  }
  if (project.scene.ends_with(".toml")) {
    add(project.scene);
  }
  return files;
}

bool isRepeatable(const Project& project) {
  return std::ranges::none_of(project.cameras, &ProjectCamera::isLive);
}

std::string runInputText(const Project& project) {
  Project run = project;
  run.markers.clear();
  run.grid.reset();
  run.measuredPoints.clear();
  run.truthFile.reset();
  run.windowLayout.clear();
  run.output = {};
  return projectText(run, folderOf(project));
}

std::string nonDefaultSettings(const Project& project) {
  std::vector<std::string> settings;
  for (const ParameterDeclaration& one : project.parameters.declarations()) {
    const double value = project.parameters.at(one.key);
    if (project.parameters.isGiven(one.key) && value != one.defaultValue) {
      settings.push_back(fmt::format("{}={}", one.key, value));
    }
  }
  if (project.volumeOfInterest) {
    const auto& [min, max] = *project.volumeOfInterest;
    settings.push_back(fmt::format("volume={},{},{},{},{},{}", min.x(), min.y(), min.z(), max.x(),
                                   max.y(), max.z()));
  }
  return fmt::format("{}", fmt::join(settings, " "));
}

} // namespace dewpoint::project
