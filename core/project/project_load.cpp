// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_load.h"

#include "core/base/limits.h"
#include "core/base/table_reader.h"
#include "core/base/toml_text.h"
#include "core/calibration/formats/calibration_file.h"
#include "core/calibration/formats/camera_calibration.h"
#include "core/project/project_check.h"
#include "core/project/project_corrections.h"
#include "core/project/project_devices.h"
#include "core/project/project_format.h"
#include "core/project/project_migration.h"
#include "core/project/project_output.h"
#include "core/project/project_paths.h"
#include "core/project/project_people.h"
#include "core/project/project_records.h"
#include "core/project/project_room.h"
#include "core/project/project_targets.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/people_state.h"

#include <cmath>
#include <iterator>

namespace dewpoint::project {
namespace {

using std::filesystem::path;

/// The text with its variables replaced.
std::string expanded(TableReader& reader, const char* key, const std::string& text) {
  const auto found = expandVariables(text);
  if (!found) {
    reader.fail(found.error().code, key, found.error().detail);
  }
  return found.value_or(text);
}

/// A path of the file, absolute.
path readPath(TableReader& reader, const char* key, const ProjectPaths& place) {
  std::string text;
  reader.readText(key, text);
  if (text.empty()) {
    if (reader.has(key)) {
      reader.fail(ErrorCode::BadValue, key, "the path is empty");
    }
    return {};
  }
  return place.pathOf(expanded(reader, key, text));
}

void readCrop(TableReader& reader, ImageMargins& crop) {
  constexpr double kMostCropPixels = 32767.0;
  double sides[4] = {0.0, 0.0, 0.0, 0.0};
  if (!reader.readNumbers("crop", sides, 4, 0.0, kMostCropPixels)) {
    return;
  }
  if (std::ranges::any_of(sides, [](double side) { return side != std::floor(side); })) {
    reader.fail(ErrorCode::BadValue, "crop", "whole numbers of pixels are expected");
    return;
  }
  crop = {static_cast<int>(sides[0]), static_cast<int>(sides[1]), static_cast<int>(sides[2]),
          static_cast<int>(sides[3])};
}

/// Where the images come from: exactly one of the source keys.
void readSource(TableReader& reader, const ProjectPaths& place, ProjectCamera& camera) {
  const bool hasVideo = reader.has("video");
  int sources = 0;
  for (const auto& [key, kind] : kSourceKeys) {
    if (!reader.has(key)) {
      continue;
    }
    ++sources;
    camera.source = kind;
    if (kind == SourceKind::Video || kind == SourceKind::Images) {
      camera.location = readPath(reader, key, place).string();
    } else {
      reader.readText(key, camera.location);
      camera.location = expanded(reader, key, camera.location);
    }
  }
  if (sources != 1) {
    reader.fail(sources == 0 ? ErrorCode::MissingKey : ErrorCode::BadValue,
                hasVideo ? "video" : "video, images, device or stream",
                "exactly one source is expected");
  }
  reader.readInteger("rotate", camera.rotateDegrees, 0, 270);
  if (camera.rotateDegrees % 90 != 0) {
    reader.fail(ErrorCode::BadValue, "rotate", "0, 90, 180 or 270 degrees are expected");
  }
  reader.readBoolean("mirror", camera.isMirrored);
  readCrop(reader, camera.crop);
  reader.readNumber("late_by", camera.delay, -kMaxDelay, kMaxDelay);
  camera.captureTimeFile = readPath(reader, "times", place).string();
}

bool hasSource(const toml::table& camera) {
  return std::ranges::any_of(kSourceKeys,
                             [&](const auto& key) { return camera.contains(key.first); });
}

ProjectCamera readCamera(const toml::table& table, const std::string& file,
                         const ProjectPaths& place, std::size_t index, bool ofScene,
                         const CameraRig& calibrated, bool withoutCalibration,
                         std::optional<Error>& error) {
  const std::string prefix = fmt::format("camera {}.", index + 1);
  TableReader reader(table, file, prefix);
  ProjectCamera camera;
  std::string name;
  reader.require("name");
  reader.readText("name", name);
  if (ofScene) {
    camera.hasOwnCalibration = true; // its images are the scene's
  } else {
    readSource(reader, place, camera);
  }
  camera.backgroundImageFile = readPath(reader, "empty_room", place).string();
  if (const toml::table* calibration = reader.findTable("calibration")) {
    auto read = cameraFromToml(*calibration, file, prefix + "calibration.");
    if (read) {
      camera.camera = std::move(*read);
    } else {
      reader.recordError(read.error());
    }
  } else {
    const auto found = std::ranges::find(calibrated, name, &Camera::name);
    if (found == calibrated.end() && withoutCalibration) {
      camera.camera.intrinsics = {}; // its images say what size they are
    } else if (found == calibrated.end()) {
      reader.fail(ErrorCode::MissingKey, "calibration",
                  "neither the project nor a calibration file contains one for '" + name + "'");
    } else {
      camera.camera = *found;
    }
  }
  camera.camera.name = name;
  readDeviceSettings(reader, file, prefix, camera);
  camera.calibrationRecord = readCameraRecord(reader, file, prefix);
  error = reader.finish();
  return camera;
}

void readParameters(const toml::table& table, const std::string& file, Project& project,
                    std::optional<Error>& error) {
  for (const auto& [key, node] : table) {
    const auto value = tomlNumber(node);
    const std::string field = "parameters." + std::string(key.str());
    if (!value) {
      error = Error{ErrorCode::WrongType, file, field,
                    fmt::format("a number is expected, line {}", node.source().begin.line)};
      return;
    }
    if (auto set = project.parameters.set(key.str(), *value); !set) {
      error = Error{set.error().code, file, field,
                    fmt::format("{}, line {}", set.error().detail, node.source().begin.line)};
      return;
    }
  }
}

void readHead(TableReader& reader, const ProjectPaths& place, Project& project) {
  std::int64_t format = kProjectFormat;
  reader.require("format");
  reader.readInteger("format", format, 1, std::int64_t{1} << 30);
  if (format > kProjectFormat) {
    reader.fail(
        ErrorCode::BadValue, "format",
        fmt::format(
            "the file is in format {}, of a newer Dewpoint; this version reads formats up to {}",
            format, kProjectFormat));
  }
  reader.readText("name", project.name);
  reader.readText("method", project.method);
  const auto methods = methodNames();
  if (std::ranges::find(methods, project.method) == methods.end()) {
    reader.fail(ErrorCode::BadValue, "method",
                fmt::format("known methods: {}", fmt::join(methods, ", ")));
  }
  reader.readInteger("seed", project.seed, 0, std::numeric_limits<std::int64_t>::max());
  reader.readNumber("frames_per_second", project.framesPerSecond, 0.0, 100000.0);
  if (const path truth = readPath(reader, "truth", place); !truth.empty()) {
    project.truthFile = truth;
  }
  reader.readText("scene", project.scene);
  if (project.scene.ends_with(".toml")) {
    project.scene = readPath(reader, "scene", place).string();
  }
}

CameraRig readCalibrationFile(TableReader& reader, const ProjectPaths& place) {
  const path file = readPath(reader, "calibration", place);
  if (file.empty()) {
    return {};
  }
  auto rig = loadCalibration(file);
  if (!rig) {
    reader.recordError(rig.error());
    return {};
  }
  return std::move(*rig);
}

void readParts(TableReader& reader, const std::string& file, const ProjectPaths& place,
               Project& project) {
  const CameraRig calibrated = readCalibrationFile(reader, place);
  project.parameters = ParameterValues(methodParameters(project.method));
  std::optional<Error> error;
  if (const toml::table* parameters = reader.findTable("parameters");
      parameters != nullptr && !reader.failed()) {
    readParameters(*parameters, file, project, error);
    reader.recordError(error);
  }
  for (const toml::table* table : reader.findTables("target", limits::kMaxTargets)) {
    project.targets.push_back(readTarget(*table, file, project.targets.size(), error));
    reader.recordError(error);
  }
  for (const toml::table* table : reader.findTables("camera", limits::kMaxCameras)) {
    project.cameras.push_back(readCamera(*table, file, place, project.cameras.size(),
                                         !project.scene.empty() && !hasSource(*table), calibrated,
                                         !methodFamily(project.method).needsCalibration, error));
    reader.recordError(error);
  }
}

void readMarkers(TableReader& reader, const std::string& file, Project& project) {
  for (const toml::table* table : reader.findTables("mark")) {
    TableReader one(*table, file, fmt::format("mark {}.", project.markers.size() + 1));
    ProjectMarker& marker = project.markers.emplace_back();
    one.require("frame");
    one.readInteger("frame", marker.frame, 0, limits::kMaxFrames);
    one.readText("name", marker.name);
    reader.recordError(one.finish());
  }
  std::ranges::stable_sort(project.markers, {}, &ProjectMarker::frame);
}

void readWindow(TableReader& reader, const std::string& file, Project& project) {
  if (const toml::table* table = reader.findTable("window")) {
    TableReader window(*table, file, "window.");
    window.readText("layout", project.windowLayout);
    reader.recordError(window.finish());
  }
}

} // namespace

Result<Project> loadProject(const std::filesystem::path& file, const MovedFiles& moved) {
  auto table = readTomlFile(file);
  if (!table) {
    return tl::make_unexpected(table.error());
  }
  // A newer format is refused below, with the line where it stands.
  if (const auto* format = (*table)["format"].as_integer();
      format != nullptr && format->get() >= 1 && format->get() < kProjectFormat) {
    migrateProject(*table, format->get());
  }
  Project project;
  project.file = std::filesystem::absolute(file);
  project.name = file.stem().string();
  TableReader reader(*table, file.string(), "");
  const ProjectPaths place{project.file.parent_path(), moved};
  readHead(reader, place, project);
  readParts(reader, file.string(), place, project);
  readMarkers(reader, file.string(), project);
  readRoom(reader, file.string(), project);
  readPeople(reader, file.string(), project);
  readCorrections(reader, file.string(), project);
  project.worldRecord = readWorldRecord(reader, file.string());
  readOutput(reader, file.string(), project);
  readWindow(reader, file.string(), project);
  if (auto error = reader.finish()) {
    return tl::make_unexpected(std::move(*error));
  }
  if (auto good = checkProject(project); !good) {
    return tl::make_unexpected(
        Error{good.error().code, file.string(), good.error().field, good.error().detail});
  }
  return project;
}

} // namespace dewpoint::project
