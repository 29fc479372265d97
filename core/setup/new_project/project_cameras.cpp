// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/new_project/project_cameras.h"

#include "core/capture/gstreamer/open_live.h"
#include "core/capture/redacted_location.h"
#include "core/geometry/camera_name.h"
#include "core/setup/new_project/image_size.h"
#include "core/setup/new_project/new_project.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace dewpoint::setup {
namespace {

/// Which parts of a calibration are only guessed.
struct GuessedParts {
  bool lens = false;
  bool pose = false;
};

std::vector<GuessedParts> guessedParts(const Project& project) {
  std::vector<GuessedParts> parts;
  for (std::size_t k = 0; k < project.cameras.size(); ++k) {
    parts.push_back({hasGuessedLens(project, k), hasGuessedPose(project, k)});
  }
  return parts;
}

/// Guesses these parts again, for the present number of cameras and the present size.
void guessAgain(Project& project, std::size_t camera, const GuessedParts& parts) {
  if (!parts.pose) {
    return; // a guessed lens depends on its size only
  }
  const Camera before = project.cameras[camera].camera;
  guessCalibration(project, camera, {before.intrinsics.width, before.intrinsics.height});
  if (!parts.lens) {
    Camera& now = project.cameras[camera].camera;
    const auto pose = now.cameraFromWorld;
    now = before;
    now.cameraFromWorld = pose;
  }
}

void guessAgain(Project& project, const std::vector<GuessedParts>& parts) {
  for (std::size_t k = 0; k < parts.size(); ++k) {
    guessAgain(project, k, parts[k]);
  }
}

bool isNameTaken(const Project& project, const std::string& name) {
  return std::ranges::any_of(
      project.cameras, [&](const ProjectCamera& camera) { return camera.camera.name == name; });
}

std::string nameFor(const Project& project, const CameraSource& source) {
  std::string wanted = source.name;
  if (wanted.empty() && comesFromRecording(source.kind)) {
    const std::filesystem::path path(source.location);
    wanted = (source.kind == SourceKind::Images ? path.filename() : path.stem()).string();
  }
  if (wanted.empty()) {
    std::size_t index = project.cameras.size();
    while (isNameTaken(project, defaultCameraName(index))) {
      ++index;
    }
    return defaultCameraName(index);
  }
  std::string name = wanted;
  for (std::size_t k = 2; isNameTaken(project, name); ++k) {
    name = fmt::format("{} {}", wanted, k);
  }
  return name;
}

tl::unexpected<Error> refusedMixture() {
  return failure(ErrorCode::Mismatch, "", "camera",
                 "live cameras and recordings cannot be mixed in one project");
}

/// Size of the images of a source after the rotation and the cropping of the camera.
cv::Size preparedSize(const cv::Size& size, const ProjectCamera& camera) {
  const bool isUpright = camera.rotateDegrees % 180 == 0;
  return {(isUpright ? size.width : size.height) - camera.crop.width(),
          (isUpright ? size.height : size.width) - camera.crop.height()};
}

/// Whether a camera has this source already. Where both devices are known, their place does not
/// count: another one may be plugged in there by now.
bool isSameSource(const ProjectCamera& camera, const CameraSource& source) {
  const DeviceIdentity& has = camera.device.identity;
  const DeviceIdentity& wanted = source.device.identity;
  if (camera.source != source.kind) {
    return false;
  }
  return has.isEmpty() || wanted.isEmpty() ? camera.location == source.location : has == wanted;
}

bool isSameModel(const DeviceIdentity& one, const DeviceIdentity& other) {
  return !one.isEmpty() && one.vendorAndProductId == other.vendorAndProductId &&
         one.name == other.name;
}

} // namespace

bool comesFromRecording(SourceKind kind) {
  return kind == SourceKind::Video || kind == SourceKind::Images;
}

std::string shownLocation(const std::string& location) {
  return redactedLocation(location);
}

Result<CameraSource> sourceAt(const std::string& location, const std::string& name) {
  CameraSource source{name, guessSourceKind(location), location, {}, {}};
  if (location.empty()) {
    return failure(ErrorCode::BadValue, "", name, "it has no source of images");
  }
  if (!comesFromRecording(source.kind)) {
    LiveCamera camera;
    camera.location = location;
    return capture::checkLocation(camera).map([&] { return source; });
  }
  auto path = std::filesystem::absolute(location).lexically_normal();
  if (path.filename().empty()) {
    path = path.parent_path(); // a folder that was written with a / at its end
  }
  source.location = path.string();
  if (!std::filesystem::exists(path)) {
    return failure(ErrorCode::FileMissing, source.location, name, "");
  }
  ProjectCamera camera;
  camera.source = source.kind;
  camera.location = source.location;
  const auto size = imageSizeOf(camera);
  if (!size) {
    return tl::make_unexpected(size.error());
  }
  source.size = *size;
  return source;
}

Status checkCanAddCamera(const Project& project, SourceKind kind) {
  if (!project.scene.empty()) {
    return failure(ErrorCode::BadValue, "", "scene", "a simulated scene has its own cameras");
  }
  const bool fits = std::ranges::all_of(project.cameras, [&](const ProjectCamera& camera) {
    return comesFromRecording(camera.source) == comesFromRecording(kind);
  });
  return fits ? Status() : refusedMixture();
}

Status addCameras(Project& project, const std::vector<CameraSource>& sources) {
  for (const CameraSource& source : sources) {
    if (auto fits = checkCanAddCamera(project, source.kind); !fits) {
      return fits;
    }
    if (comesFromRecording(source.kind) != comesFromRecording(sources.front().kind)) {
      return refusedMixture();
    }
  }
  std::vector<GuessedParts> parts = guessedParts(project);
  for (const CameraSource& source : sources) {
    ProjectCamera added;
    added.camera.name = nameFor(project, source);
    added.source = source.kind;
    added.location = source.location;
    added.device = source.device;
    const bool isKnown = source.size.width > 0 && source.size.height > 0;
    added.camera.intrinsics.width = isKnown ? source.size.width : kAssumedImageWidth;
    added.camera.intrinsics.height = isKnown ? source.size.height : kAssumedImageHeight;
    project.cameras.push_back(std::move(added));
    parts.push_back({true, true});
  }
  guessAgain(project, parts);
  return {};
}

Status replaceSource(Project& project, std::size_t camera, const CameraSource& source) {
  const auto other = std::ranges::find_if(
      project.cameras, [&](const ProjectCamera& one) { return isSameSource(one, source); });
  ProjectCamera& changed = project.cameras[camera];
  if (other != project.cameras.end()) {
    swapSources(project, camera, static_cast<std::size_t>(other - project.cameras.begin()));
    return {};
  }
  if (project.cameras.size() > 1 || !project.scene.empty()) {
    if (auto fits = checkCanAddCamera(project, source.kind); !fits) {
      return fits;
    }
  }
  if (source.size.width > 0 && source.size.height > 0) {
    const cv::Size size = preparedSize(source.size, changed);
    if (size.width < 1 || size.height < 1) {
      return failure(ErrorCode::Mismatch, source.location, changed.camera.name,
                     fmt::format("its images have {} x {} pixels, of which cropping leaves nothing",
                                 source.size.width, source.size.height));
    }
    const Intrinsics& lens = changed.camera.intrinsics;
    if (hasGuessedLens(project, camera) && hasGuessedPose(project, camera)) {
      guessCalibration(project, camera, size);
    } else if (size != cv::Size(lens.width, lens.height) && comesFromRecording(source.kind)) {
      return failure(ErrorCode::Mismatch, source.location, changed.camera.name,
                     fmt::format("its images have {} x {} pixels, and the camera is calibrated for "
                                 "{} x {}",
                                 size.width, size.height, lens.width, lens.height));
    }
  }
  changed.source = source.kind;
  changed.location = source.location;
  if (isSameModel(changed.device.identity, source.device.identity)) {
    changed.device.identity = source.device.identity; // format and controls suit it, too
  } else {
    changed.device = source.device;
  }
  changed.captureTimeFile.clear();
  return {};
}

void swapSources(Project& project, std::size_t one, std::size_t other) {
  ProjectCamera& first = project.cameras[one];
  ProjectCamera& second = project.cameras[other];
  std::swap(first.source, second.source);
  std::swap(first.location, second.location);
  std::swap(first.captureTimeFile, second.captureTimeFile);
  std::swap(first.device, second.device);
}

Status removeProjectCamera(Project& project, std::size_t camera) {
  if (!project.scene.empty()) {
    return failure(ErrorCode::BadValue, "", "scene", "a simulated scene has its own cameras");
  }
  if (project.cameras.size() < 2) {
    return failure(ErrorCode::MissingKey, "", "camera", "a project needs at least one camera");
  }
  std::vector<GuessedParts> parts = guessedParts(project);
  parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(camera));
  removeCamera(project, camera);
  guessAgain(project, parts);
  return {};
}

} // namespace dewpoint::setup
