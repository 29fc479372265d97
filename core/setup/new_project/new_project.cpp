// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/new_project/new_project.h"

#include "core/calibration/formats/calibration_file.h"
#include "core/camera_motion/agreement/rig_check.h"
#include "core/geometry/camera_name.h"
#include "core/project/project_check.h"
#include "core/project/project_rig.h"
#include "core/setup/new_project/image_size.h"
#include "core/tracking/catalog/method_catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace dewpoint::setup {
namespace {

bool isRecording(SourceKind source) {
  return source == SourceKind::Video || source == SourceKind::Images;
}

std::string nameOf(const NewCamera& camera, std::size_t index) {
  if (!camera.name.empty()) {
    return camera.name;
  }
  if (!isRecording(camera.sourceKind)) {
    return defaultCameraName(index);
  }
  const std::filesystem::path path(camera.location);
  const bool isFolder = camera.sourceKind == SourceKind::Images;
  const auto name = isFolder && path.filename().empty() ? path.parent_path().filename()
                    : isFolder                          ? path.filename()
                                                        : path.stem();
  return name.string();
}

/// What a project is called that nobody named: the folder its recordings lie in, or what its only
/// camera is called.
std::string nameOf(const std::vector<ProjectCamera>& cameras) {
  const ProjectCamera& first = cameras.front();
  return cameras.size() > 1 && isRecording(first.source)
             ? std::filesystem::path(first.location).parent_path().filename().string()
             : first.camera.name;
}

/// Made different where two are called the same: the same file name in two folders.
void makeDistinct(std::vector<ProjectCamera>& cameras) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    std::string& name = cameras[i].camera.name;
    const std::string wanted = name;
    for (std::size_t k = 2; !seen.insert(name).second; ++k) {
      name = fmt::format("{} {}", wanted, k);
    }
  }
}

Status checkLocation(const ProjectCamera& camera) {
  if (camera.location.empty()) {
    return failure(ErrorCode::BadValue, "", camera.camera.name, "it has no source of images");
  }
  if (isRecording(camera.source) && !std::filesystem::exists(camera.location)) {
    return failure(ErrorCode::FileMissing, camera.location, camera.camera.name, "");
  }
  return {};
}

/// Calibrations in the order of the cameras, by name or else by order.
Result<CameraRig> matched(const std::vector<ProjectCamera>& cameras, const CameraRig& rig,
                          const std::string& file, bool& byOrder) {
  CameraRig ordered;
  for (const ProjectCamera& camera : cameras) {
    const auto found = std::ranges::find(rig, camera.camera.name, &Camera::name);
    if (found != rig.end()) {
      ordered.push_back(*found);
    }
  }
  if (ordered.size() == cameras.size()) {
    return ordered;
  }
  if (ordered.empty() && rig.size() == cameras.size()) {
    byOrder = true;
    return rig;
  }
  std::vector<std::string> names;
  names.reserve(cameras.size());
  for (const ProjectCamera& camera : cameras) {
    names.push_back(camera.camera.name);
  }
  return failure(ErrorCode::Mismatch, file, "",
                 fmt::format("it has {} cameras ({}), and the project has {} ({}): match them with "
                             "--map \"{}={}\"",
                             rig.size(), quotedNames(rig), names.size(), quotedNames(names),
                             names.front(), rig.empty() ? "NAME" : rig.front().name));
}

/// 53 degrees wide, at `index` of a ring of `count` around a box of 1 m.
Camera guessedCamera(std::size_t index, std::size_t count, const cv::Size& size) {
  constexpr double kDistance = 2.0; // meters
  /// Meters.
  constexpr double kHeight = 1.2;
  const double angle = 2.0 * std::numbers::pi * static_cast<double>(index) /
                       static_cast<double>(std::max<std::size_t>(4, count));
  Camera camera;
  const double focal = size.width;
  camera.intrinsics = {
      size.width, size.height, focal, focal, 0.5 * (size.width - 1), 0.5 * (size.height - 1)};
  camera.cameraFromWorld =
      lookAt({kDistance * std::cos(angle), kDistance * std::sin(angle), kHeight}, {0.0, 0.0, 0.25});
  return camera;
}

void takeGuess(std::vector<ProjectCamera>& cameras, std::size_t index, const cv::Size& size) {
  const std::string name = cameras[index].camera.name;
  cameras[index].camera = guessedCamera(index, cameras.size(), size);
  cameras[index].camera.name = name;
}

Status guess(std::vector<ProjectCamera>& cameras, std::size_t index) {
  ProjectCamera& camera = cameras[index];
  cv::Size size(kAssumedImageWidth, kAssumedImageHeight);
  if (isRecording(camera.source)) {
    const auto real = imageSizeOf(camera);
    if (!real) {
      return tl::make_unexpected(real.error());
    }
    size = *real;
  }
  takeGuess(cameras, index, size);
  return {};
}

/// The first of those that need none; the default one when all need it.
std::string methodWithoutCalibration() {
  const auto needs = [](const Method& method) { return method.family.needsCalibration; };
  const auto found = std::ranges::find_if_not(methods(), needs);
  return std::string(found != methods().end() ? found->name : methods().front().name);
}

} // namespace

SourceKind guessSourceKind(const std::string& location) {
  const bool isNumber =
      !location.empty() &&
      std::ranges::all_of(location, [](unsigned char letter) { return std::isdigit(letter) != 0; });
  if (isNumber || location.starts_with("/dev/")) {
    return SourceKind::Device;
  }
  if (location.starts_with("gst:") || location.starts_with("test:") ||
      location.find("://") != std::string::npos) {
    return SourceKind::Stream;
  }
  std::error_code problem;
  return std::filesystem::is_directory(location, problem) ? SourceKind::Images : SourceKind::Video;
}

Result<CreatedProject> createNewProject(const NewProject& wanted) {
  CreatedProject made;
  Project& project = made.project;
  if (wanted.cameras.size() == 1 && !wanted.calibrationFile) {
    project.method = methodWithoutCalibration(); // nothing else is of use
  }
  project.parameters = ParameterValues(methodParameters(project.method));
  project.framesPerSecond = wanted.framesPerSecond;
  for (std::size_t i = 0; i < wanted.cameras.size(); ++i) {
    const NewCamera& camera = wanted.cameras[i];
    ProjectCamera added;
    added.camera.name = nameOf(camera, i);
    added.source = camera.sourceKind;
    added.location = isRecording(camera.sourceKind) && !camera.location.empty()
                         ? std::filesystem::absolute(camera.location).lexically_normal().string()
                         : camera.location;
    if (auto good = checkLocation(added); !good) {
      return tl::make_unexpected(good.error());
    }
    project.cameras.push_back(std::move(added));
  }
  if (project.cameras.empty()) {
    return failure(ErrorCode::MissingKey, "", "camera", "a project needs at least one camera");
  }
  makeDistinct(project.cameras);
  project.name = !wanted.name.empty() ? wanted.name : nameOf(project.cameras);
  if (!wanted.calibrationFile) {
    made.lacksCalibration = methodFamily(project.method).needsCalibration;
    for (std::size_t i = 0; i < project.cameras.size(); ++i) {
      if (auto guessed = guess(project.cameras, i); !guessed) {
        return tl::make_unexpected(guessed.error());
      }
    }
    return made;
  }
  return withCalibration(std::move(project), *wanted.calibrationFile, wanted.adaptation);
}

Status guessMissingCameras(Project& project) {
  bool any = false;
  for (std::size_t i = 0; i < project.cameras.size(); ++i) {
    if (project.cameras[i].camera.intrinsics.width == 0) {
      if (auto guessed = guess(project.cameras, i); !guessed) {
        return guessed;
      }
      any = true;
    }
  }
  return any ? checkProject(project) : Status(); // boxes may lie beyond the images
}

bool hasGuessedPose(const Project& project, std::size_t index) {
  constexpr double kRounding = 1e-6; // of a file
  const Camera& camera = project.cameras[index].camera;
  const Camera guessed = guessedCamera(index, project.cameras.size(),
                                       {camera.intrinsics.width, camera.intrinsics.height});
  return camera.cameraFromWorld.isApprox(guessed.cameraFromWorld, kRounding);
}

bool hasGuessedLens(const Project& project, std::size_t index) {
  const Camera& camera = project.cameras[index].camera;
  const Camera guessed = guessedCamera(index, project.cameras.size(),
                                       {camera.intrinsics.width, camera.intrinsics.height});
  return camera.intrinsics == guessed.intrinsics && !camera.hasDistortion();
}

bool hasGuessedPose(const Project& project) {
  for (std::size_t index = 0; index < project.cameras.size(); ++index) {
    if (hasGuessedPose(project, index)) {
      return true;
    }
  }
  return false;
}

void guessCalibration(Project& project, std::size_t camera, const cv::Size& size) {
  takeGuess(project.cameras, camera, size);
}

std::filesystem::path proposedProjectFile(const Project& project) {
  std::string name = project.name.empty() ? "project" : project.name;
  std::ranges::replace_if(
      name, [](unsigned char letter) { return letter == '/' || letter == '\\' || letter < ' '; },
      '_'); // a name is no path
  const std::string file = name + ".toml";
  const auto recorded = std::ranges::find_if(
      project.cameras, [](const ProjectCamera& camera) { return isRecording(camera.source); });
  return recorded == project.cameras.end()
             ? std::filesystem::path(file)
             : std::filesystem::path(recorded->location).parent_path() / file;
}

Result<CreatedProject> withCalibration(Project project, const std::filesystem::path& file,
                                       const CalibrationAdaptation& adaptation) {
  auto rig = loadCalibration(file);
  if (!rig) {
    return tl::make_unexpected(rig.error());
  }
  if (const auto named = renameCameras(*rig, adaptation.cameraRenaming, file.string()); !named) {
    return tl::make_unexpected(named.error());
  }
  return withCalibration(std::move(project), *rig, file.string(), adaptation.sizeFit);
}

Result<CreatedProject> withCalibration(Project project, const CameraRig& rig,
                                       const std::string& file, const std::optional<SizeFit>& fit) {
  CreatedProject made;
  auto ordered = matched(project.cameras, rig, file, made.wereCamerasMatchedByOrder);
  if (!ordered) {
    return tl::make_unexpected(ordered.error());
  }
  made.project = std::move(project);
  auto& cameras = made.project.cameras;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    (*ordered)[i].name = cameras[i].camera.name;
    cameras[i].camera = (*ordered)[i];
    if (const auto fits = fitCalibration(cameras[i], fit, file, made.decisions); !fits) {
      return tl::make_unexpected(fits.error());
    }
    cameras[i].calibrationRecord = {recordOfLens(cameras[i].camera, CalibrationOrigin::File),
                                    recordOfPose(cameras[i].camera, CalibrationOrigin::File)};
  }
  made.project.worldRecord = {};
  made.project.worldRecord.scaleOrigin = CalibrationOrigin::File;
  made.project.worldRecord.floorOrigin = CalibrationOrigin::File;
  made.likelyMistakes = camera_motion::checkRig(rigOf(made.project));
  return made;
}

} // namespace dewpoint::setup
