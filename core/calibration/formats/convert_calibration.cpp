// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/convert_calibration.h"

#include "core/base/text_file.h"
#include "core/calibration/formats/calibration_plausibility.h"
#include "core/calibration/formats/format_catalog.h"
#include "core/calibration/formats/lens_refit.h"
#include "core/calibration/formats/read_calibration.h"
#include "core/geometry/camera_name.h"
#include "core/geometry/projector.h"
#include "core/geometry/ray.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::calibration {
namespace {

/// Points along each side of the image at which lenses are compared.
constexpr int kRayGrid = 9;
constexpr double kDepths[] = {0.3, 1.0, 3.0, 10.0}; // meters along the ray

/// The format a person named, or the only one with the path's ending.
Result<const CalibrationFormat*> targetFormat(const CalibrationOutput& target) {
  if (!target.format.empty()) {
    return findCalibrationFormat(target.format);
  }
  const std::string name = target.path.filename().string();
  const CalibrationFormat* only = nullptr;
  for (const CalibrationFormat& format : calibrationFormats()) {
    if (format.write != nullptr && name.ends_with(format.extension)) {
      // .toml is ours unless asked otherwise
      if (std::string(format.name) == "dewpoint") {
        return &format;
      }
      if (only != nullptr) {
        return failure(
            ErrorCode::BadValue, target.path.string(), "",
            fmt::format("several formats use the extension {}; use --to {} or another format",
                        format.extension, only->name));
      }
      only = &format;
    }
  }
  if (only == nullptr) {
    return failure(ErrorCode::BadValue, target.path.string(), "",
                   "no format uses its extension; use --to FORMAT");
  }
  return only;
}

Status checkRigFits(const CalibrationFormat& format, const CameraRig& rig,
                    const std::string& file) {
  if (format.write == nullptr) {
    return failure(ErrorCode::BadValue, file, "",
                   fmt::format("{} can only be read, not written", format.title));
  }
  if (rig.empty()) {
    return failure(ErrorCode::MissingKey, file, "", "there is no camera to write");
  }
  const auto size = [](const Camera& camera) {
    return std::pair(camera.intrinsics.width, camera.intrinsics.height);
  };
  if (format.layout == FileLayout::CameraPair &&
      (rig.size() != 2 || size(rig[0]) != size(rig[1]))) {
    return failure(ErrorCode::Mismatch, file, "",
                   fmt::format("a file of the format {} has exactly two cameras with images of the "
                               "same size; this calibration has {} cameras",
                               format.title, rig.size()));
  }
  return {};
}

/// The rig as the format holds it, in meters, with what had to be changed as sentences.
CameraRig fitted(const CalibrationFormat& format, const CameraRig& rig,
                 CalibrationConversion& conversion) {
  CameraRig result;
  const Eigen::Isometry3d worldFromNew = format.firstCameraIsWorld
                                             ? rig.front().cameraFromWorld.inverse()
                                             : Eigen::Isometry3d::Identity();
  for (const Camera& camera : rig) {
    const LensRefit refit = refitLens(camera, format.lensSupport);
    result.push_back(refit.camera);
    result.back().cameraFromWorld = camera.cameraFromWorld * worldFromNew;
    conversion.cameraDifferences.push_back({camera.name, refit.isRefitted, 0.0, 0});
    if (refit.isRefitted) {
      conversion.decisions.push_back(
          fmt::format("{} has no lens model like that of {}: focal lengths, principal point and {} "
                      "coefficients were fitted by least squares over the image (RMS {:.3g} px).",
                      format.title, camera.name, format.lensSupport.pinholeCoefficientCount,
                      refit.rmsDifferencePx));
    }
  }
  if (format.firstCameraIsWorld) {
    result.front().cameraFromWorld.setIdentity(); // exactly
    conversion.decisions.push_back(
        fmt::format("{} has no world coordinates: the axes of the first camera are used instead.",
                    format.title));
  }
  return result;
}

CameraRig inUnit(CameraRig rig, double unit) {
  for (Camera& camera : rig) {
    camera.cameraFromWorld.translation() /= unit;
  }
  return rig;
}

/// Anipose's own projection passes over p1 and p2 (its source says so): how much that is.
void noteTangentialDistortion(const CalibrationFormat& format, const CameraRig& rig,
                              CalibrationConversion& conversion) {
  if (std::string(format.name) != "anipose") {
    return;
  }
  for (const Camera& camera : rig) {
    if (camera.lens == LensModel::Pinhole &&
        (camera.distortion[2] != 0.0 || camera.distortion[3] != 0.0)) {
      Camera plain = camera;
      plain.distortion[2] = plain.distortion[3] = 0.0;
      conversion.decisions.push_back(fmt::format(
          "Anipose ignores p1 and p2 when it projects points. This causes errors of up to {:.3g} "
          "px in {}.",
          compareCameras(camera, plain, Eigen::Isometry3d::Identity()).maxDifferencePx,
          camera.name));
    }
  }
}

Status writeFiles(const std::vector<CalibrationText>& files, const CalibrationOutput& target,
                  CalibrationConversion& conversion) {
  std::error_code problem;
  for (const CalibrationText& file : files) {
    if (!target.replacesExisting && std::filesystem::exists(file.file, problem)) {
      return failure(ErrorCode::FileUnwritable, file.file.string(), "",
                     "it already exists; use --force to replace it");
    }
  }
  for (const CalibrationText& file : files) {
    if (file.file.has_parent_path()) {
      std::filesystem::create_directories(file.file.parent_path(), problem);
    }
    if (auto status = writeTextFile(file.file, file.text); !status) {
      return status;
    }
    conversion.writtenFiles.push_back(file.file);
  }
  return {};
}

/// Reads what was written, each camera from a file of its own where it has one: a folder may hold
/// other calibrations too.
Result<CameraRig> readBack(const CalibrationFormat& format,
                           const std::vector<CalibrationText>& files, const CameraRig& rig,
                           double unit) {
  CalibrationHints hints;
  hints.format = format.name;
  hints.metersPerUnit = unit;
  hints.posesAreWorldFromCamera = false;
  hints.imageSize = {rig.front().intrinsics.width, rig.front().intrinsics.height};
  CameraRig again;
  const std::size_t count = format.layout == FileLayout::FilePerCamera ? rig.size() : 1;
  for (std::size_t k = 0; k < count; ++k) {
    auto part = readCalibration(files[k].file, hints);
    if (!part) {
      return tl::make_unexpected(part.error());
    }
    std::ranges::move(part->rig, std::back_inserter(again));
  }
  return again;
}

/// A rotation alone says what size comes out.
std::array<int, 2> sizeAfter(const CalibrationChanges& changes, const Camera& camera) {
  return changes.imageSize.value_or(std::array{camera.intrinsics.height, camera.intrinsics.width});
}

Status applyChanges(const CalibrationChanges& changes, const std::string& file,
                    ParsedCalibration& calibration) {
  const auto& [names, fit] = changes.adaptation;
  if (auto named = renameCameras(calibration.rig, names, file); !named) {
    return named;
  }
  for (Camera& camera : calibration.rig) {
    if (!fit) {
      break;
    }
    const auto [width, height] = sizeAfter(changes, camera);
    auto fitted = fittedToSize(camera, width, height, *fit);
    if (!fitted) {
      fitted.error().file = file;
      return tl::make_unexpected(fitted.error());
    }
    calibration.decisions.push_back(sizeFitSentence(camera, *fitted, *fit));
    camera = std::move(*fitted);
  }
  return {};
}

} // namespace

CameraDifference compareCameras(const Camera& camera, const Camera& other,
                                const Eigen::Isometry3d& otherFromWorld) {
  CameraDifference result;
  result.camera = camera.name;
  const Unprojector unprojector(camera);
  const Projector mine(camera);
  const Projector theirs(other);
  for (int i = 0; i < kRayGrid * kRayGrid; ++i) {
    const Eigen::Vector2d pixel(i % kRayGrid * (camera.intrinsics.width - 1.0) / (kRayGrid - 1),
                                int(i / kRayGrid) * (camera.intrinsics.height - 1.0) /
                                    (kRayGrid - 1));
    const auto ray = unprojector.ray(pixel);
    for (const double depth : kDepths) {
      const Eigen::Vector3d point =
          ray ? Eigen::Vector3d(ray->origin + depth * ray->direction) : Eigen::Vector3d::Zero();
      const auto expected = ray ? mine.project(point) : std::nullopt;
      if (!expected) {
        continue;
      }
      if (const auto found = theirs.project(otherFromWorld * point)) {
        result.maxDifferencePx = std::max(result.maxDifferencePx, (*found - *expected).norm());
      } else if (depth == kDepths[0]) {
        ++result.unseenDirectionCount;
      }
    }
  }
  return result;
}

Result<CalibrationConversion> writeCalibration(const CameraRig& rig,
                                               const CalibrationOutput& target) {
  const auto known = targetFormat(target);
  if (!known) {
    return tl::make_unexpected(known.error());
  }
  const CalibrationFormat& format = **known;
  if (const auto status = checkRigFits(format, rig, target.path.string()); !status) {
    return tl::make_unexpected(status.error());
  }
  if (target.metersPerUnit && format.metersPerUnit &&
      *target.metersPerUnit != *format.metersPerUnit) {
    return failure(
        ErrorCode::Mismatch, target.path.string(), "unit",
        fmt::format("{} files are always in units of {} m", format.title, *format.metersPerUnit));
  }
  CalibrationConversion conversion;
  conversion.toFormat = format.name;
  const double unit =
      target.metersPerUnit.value_or(format.metersPerUnit.value_or(format.defaultMetersPerUnit));
  const CameraRig held = fitted(format, rig, conversion);
  noteTangentialDistortion(format, rig, conversion);
  conversion.decisions.push_back(
      fmt::format("Written as {}: {}.", format.title, format.description));
  conversion.decisions.push_back(unit == 1.0
                                     ? "Lengths are written in meters."
                                     : fmt::format("Lengths are written in units of {} m.", unit));
  const auto files = format.write(inUnit(held, unit), target.path);
  if (const auto status = writeFiles(files, target, conversion); !status) {
    return tl::make_unexpected(status.error());
  }
  const auto again = readBack(format, files, held, unit);
  if (!again) {
    return tl::make_unexpected(again.error());
  }
  const Eigen::Isometry3d newFromWorld =
      held.front().cameraFromWorld.inverse() * rig.front().cameraFromWorld;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    auto& camera = conversion.cameraDifferences[k];
    const auto found = compareCameras(rig[k], again->at(k), newFromWorld);
    camera.maxDifferencePx = found.maxDifferencePx;
    camera.unseenDirectionCount = found.unseenDirectionCount;
    conversion.maxDifferencePx = std::max(conversion.maxDifferencePx, camera.maxDifferencePx);
  }
  return conversion;
}

Result<CalibrationConversion> convertCalibration(const std::filesystem::path& in,
                                                 const CalibrationHints& hints,
                                                 const CalibrationOutput& target,
                                                 const CalibrationChanges& changes) {
  auto read = readCalibration(in, hints);
  if (!read) {
    return tl::make_unexpected(read.error());
  }
  if (const auto changed = applyChanges(changes, in.string(), *read); !changed) {
    return tl::make_unexpected(changed.error());
  }
  auto conversion = writeCalibration(read->rig, target);
  if (conversion) {
    conversion->fromFormat = read->format;
    for (const auto& [first, second] : camerasWithSamePose(read->rig)) {
      conversion->notices.push_back(fmt::format(
          "{} and {} have the same pose, which is probably a mistake",
          nameOrNumber(read->rig[first], first), nameOrNumber(read->rig[second], second)));
    }
    conversion->decisions.insert(conversion->decisions.begin(), read->decisions.begin(),
                                 read->decisions.end());
  }
  return conversion;
}

} // namespace dewpoint::calibration
