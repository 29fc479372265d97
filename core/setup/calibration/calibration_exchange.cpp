// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/calibration_exchange.h"

#include "core/calibration/formats/calibration_file.h"
#include "core/calibration/formats/format_catalog.h"
#include "core/calibration/formats/format_dewpoint.h"
#include "core/calibration/formats/read_calibration.h"
#include "core/camera_motion/agreement/rig_check.h"
#include "core/project/project_check.h"
#include "core/project/project_rig.h"
#include "core/setup/calibration/calibrated_project.h"
#include "core/setup/new_project/image_size.h"
#include "core/setup/new_project/new_project.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <iterator>
#include <unistd.h>

namespace dewpoint::setup {
namespace {

/// The one camera of a file under the name of the project's camera it is about.
Status nameAsRequested(const Project& project, const ImportRequest& request, CameraRig& rig) {
  if (!request.camera) {
    return {};
  }
  if (*request.camera >= project.cameras.size()) {
    return failure(ErrorCode::NotFound, request.path.string(), "camera",
                   fmt::format("number {}", *request.camera + 1));
  }
  const std::string& name = project.cameras[*request.camera].camera.name;
  if (rig.size() != 1) {
    return failure(ErrorCode::Mismatch, request.path.string(), name,
                   fmt::format("the file has {} cameras, not one", rig.size()));
  }
  rig.front().name = name;
  return {};
}

/// The project's camera that a file of one camera is about, where the project has several.
Result<std::size_t> cameraOfFile(const Project& project, const ImportRequest& request,
                                 const std::string& name) {
  if (request.camera) {
    return *request.camera;
  }
  const auto found = std::ranges::find_if(
      project.cameras, [&](const ProjectCamera& one) { return one.camera.name == name; });
  if (found == project.cameras.end()) {
    std::vector<std::string> names;
    for (const ProjectCamera& one : project.cameras) {
      names.push_back(one.camera.name);
    }
    return failure(ErrorCode::Mismatch, request.path.string(), "camera",
                   fmt::format("the file has one camera '{}', and the project has {}: select the "
                               "camera",
                               name, quotedNames(names)));
  }
  return static_cast<std::size_t>(found - project.cameras.begin());
}

/// Takes one camera alone.
Result<CreatedProject> withOneCamera(Project project, std::size_t index, const Camera& camera,
                                     const ImportRequest& request) {
  CreatedProject made;
  made.project = std::move(project);
  ProjectCamera& changed = made.project.cameras[index];
  changed.camera = camera;
  const auto fits =
      fitCalibration(changed, request.adaptation.sizeFit, request.path.string(), made.decisions);
  changed.calibrationRecord = {recordOfLens(changed.camera, CalibrationOrigin::File),
                               recordOfPose(changed.camera, CalibrationOrigin::File)};
  return fits ? Result<CreatedProject>(std::move(made)) : tl::make_unexpected(fits.error());
}

Result<double> roundTripError(const CameraRig& rig, const std::string& file) {
  const auto ours = findCalibrationFormat("dewpoint");
  const auto again = (*ours)->read({file, calibrationText(rig)}, {});
  if (!again) {
    return tl::make_unexpected(again.error());
  }
  double largest = 0.0;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    const auto found = compareCameras(rig[k], again->rig.at(k), Eigen::Isometry3d::Identity());
    largest = std::max(largest, found.maxDifferencePx);
  }
  return largest;
}

/// A folder that goes with its last use.
class ScratchFolder {
public:
  ScratchFolder() {
    static std::atomic<int> count = 0;
    path_ = std::filesystem::temp_directory_path() /
            fmt::format("dewpoint-preview-{}-{}", ::getpid(), ++count);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

} // namespace

Result<CalibrationImport> importCalibration(const Project& project, const ImportRequest& request) {
  auto read = readCalibration(request.path, request.hints);
  if (!read) {
    return tl::make_unexpected(read.error());
  }
  const std::string file = request.path.string();
  const auto& names = request.adaptation.cameraRenaming;
  const auto named = renameCameras(read->rig, names, file).and_then([&] {
    return nameAsRequested(project, request, read->rig);
  });
  if (!named) {
    return tl::make_unexpected(named.error());
  }
  const CameraRig original = read->rig;
  std::optional<std::size_t> only; // camera that a file of one is about
  if (original.size() == 1 && project.cameras.size() > 1) {
    const auto found = cameraOfFile(project, request, original.front().name);
    if (!found) {
      return tl::make_unexpected(found.error());
    }
    only = *found;
  }
  auto made = only ? withOneCamera(project, *only, original.front(), request)
                   : withCalibration(project, read->rig, file, request.adaptation.sizeFit);
  if (!made) {
    return tl::make_unexpected(made.error());
  }
  CalibrationImport result;
  result.formatTitle = (*findCalibrationFormat(read->format))->title;
  result.decisions = read->decisions;
  result.decisions.insert(result.decisions.end(), made->decisions.begin(), made->decisions.end());
  result.wereCamerasMatchedByOrder = made->wereCamerasMatchedByOrder;
  result.hasOnlyIntrinsics = !read->hasPoses;
  CameraRig rig = rigOf(made->project);
  for (std::size_t k = 0; k < rig.size(); ++k) {
    const Camera& before = project.cameras[k].camera;
    if (result.hasOnlyIntrinsics) {
      rig[k].cameraFromWorld = before.cameraFromWorld;
      made->project.cameras[k].calibrationRecord.pose = project.cameras[k].calibrationRecord.pose;
    }
    if (only && k != *only) {
      continue;
    }
    const auto source = std::ranges::find(original, before.name, &Camera::name);
    const auto renamed = names.find(before.name);
    const std::string& from = renamed != names.end()     ? renamed->second
                              : source != original.end() ? source->name
                                                         : original[k].name;
    result.cameras.push_back({k, before.name, from, poseShift(before, rig[k])});
  }
  if (result.hasOnlyIntrinsics) {
    made->project.worldRecord = project.worldRecord;
  }
  const auto loss = roundTripError(rig, file);
  if (!loss) {
    return tl::make_unexpected(loss.error());
  }
  result.maxConversionErrorPx = *loss;
  result.likelyMistakes = camera_motion::checkRig(rig);
  result.project = withCameras(std::move(made->project), rig);
  if (const auto good = checkProject(result.project); !good) {
    return tl::make_unexpected(good.error());
  }
  return result;
}

std::vector<std::string> cameraNamesIn(const ImportRequest& request) {
  std::vector<std::string> names;
  if (const auto read = readCalibration(request.path, request.hints)) {
    std::ranges::transform(read->rig, std::back_inserter(names), &Camera::name);
  }
  return names;
}

ImportProblem importProblem(Error error) {
  constexpr std::pair<const char*, ImportQuestion> kOptions[] = {
      {"--from", ImportQuestion::Format}, {"--unit", ImportQuestion::Unit},
      {"--lens", ImportQuestion::Lens},   {"--size", ImportQuestion::Size},
      {"--poses", ImportQuestion::Poses}, {"--force", ImportQuestion::None},
      {"--to ", ImportQuestion::Format},  {"--fit", ImportQuestion::Fit},
      {"--map", ImportQuestion::Names}};
  ImportProblem asked;
  const auto option = error.detail.find("--");
  for (const auto& [name, question] : kOptions) {
    if (option != std::string::npos && error.detail.compare(option, std::strlen(name), name) == 0) {
      asked.question = question;
      const auto end = error.detail.find_last_of(";:,", option);
      error.detail.erase(end != std::string::npos ? end : 0);
      break;
    }
  }
  if (error.field == "camera") {
    asked.question = ImportQuestion::Camera;
  }
  asked.error = std::move(error);
  return asked;
}

Result<CalibrationConversion> exportCalibration(const Project& project,
                                                const CalibrationOutput& target) {
  return writeCalibration(rigOf(project), target);
}

Result<CalibrationConversion> previewExport(const Project& project, CalibrationOutput target) {
  const ScratchFolder folder;
  const std::filesystem::path wanted = target.path;
  target.path = folder.path() / (wanted.filename().empty() ? "preview" : wanted.filename());
  auto conversion = exportCalibration(project, target);
  if (!conversion) {
    conversion.error().file = wanted.string();
    return conversion;
  }
  conversion->writtenFiles.clear();
  return conversion;
}

} // namespace dewpoint::setup
