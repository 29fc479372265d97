// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/format_anipose.h"

#include "core/base/toml_text.h"
#include "core/calibration/formats/camera_parts.h"
#include "core/calibration/formats/number_text.h"
#include "core/calibration/formats/toml_cameras.h"
#include "core/geometry/rotation_vector.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::calibration {
namespace {

std::string recognizeAnipose(const CalibrationText& source) {
  return recognizeTomlDialect(source) == TomlDialect::Anipose
             ? "camera tables and [metadata] with \"adjusted\""
             : "";
}

std::string recognizePose2Sim(const CalibrationText& source) {
  return recognizeTomlDialect(source) == TomlDialect::Pose2Sim
             ? "camera tables with four coefficients and \"fisheye = false\""
             : "";
}

void setLens(CameraRig& rig, LensModel lens) {
  for (Camera& camera : rig) {
    camera.lens = lens;
  }
}

Result<ParsedCalibration> readAnipose(const CalibrationText& source,
                                      const CalibrationHints& hints) {
  // What FreeMoCap adds.
  auto cameras = camerasFromToml(source, {"world_position", "world_orientation"});
  if (!cameras) {
    return tl::make_unexpected(cameras.error());
  }
  const std::string unclear = cameraWithUnclearLens(source);
  if (!unclear.empty() && !hints.lens) {
    return failure(ErrorCode::BadValue, source.file.string(), unclear + ".distortions",
                   "four coefficients are k1 k2 p1 p2 of a pinhole, or k1 k2 k3 k4 of a fisheye; "
                   "convert with --lens pinhole or --lens fisheye");
  }
  ParsedCalibration calibration;
  calibration.rig = std::move(*cameras);
  calibration.decisions = {"The poses are stored as camera from world, as in Dewpoint."};
  if (hints.lens) {
    setLens(calibration.rig, *hints.lens);
    calibration.decisions.emplace_back(
        *hints.lens == LensModel::Fisheye
            ? "The coefficients are those of a fisheye, as requested."
            : "The coefficients are those of a pinhole, as requested.");
  } else if (std::ranges::any_of(calibration.rig, [](const Camera& camera) {
               return camera.lens == LensModel::Fisheye;
             })) {
    calibration.decisions.emplace_back("\"fisheye = true\": coefficients are k1 k2 k3 k4 of a "
                                       "fisheye.");
  }
  return calibration;
}

/// The size as `template` of fmt: Pose2Sim writes it with a decimal point.
std::string camerasText(const CameraRig& rig, int coefficients, bool saysPinhole) {
  std::string text;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    const Camera& camera = rig[k];
    const bool fisheye = camera.lens == LensModel::Fisheye;
    const double size[] = {double(camera.intrinsics.width), double(camera.intrinsics.height)};
    text += fmt::format("[cam_{}]\nname = {}\nsize = {}\nmatrix = {}\ndistortions = {}\n"
                        "rotation = {}\ntranslation = {}\n",
                        k, tomlQuoted(camera.name),
                        saysPinhole ? listText(size) : fmt::format("[{}, {}]", size[0], size[1]),
                        matrixListText(matrixOf(camera.intrinsics)),
                        listText(trimmedDistortion(camera, coefficients)),
                        listText(vectorFromRotation(camera.cameraFromWorld.linear())),
                        listText(Eigen::VectorXd(camera.cameraFromWorld.translation())));
    text += fisheye ? "fisheye = true\n\n" : saysPinhole ? "fisheye = false\n\n" : "\n";
  }
  return text;
}

std::vector<CalibrationText> writeAnipose(const CameraRig& rig, const std::filesystem::path& out) {
  return {{out, camerasText(rig, 5, false) + "[metadata]\nadjusted = true\nerror = 0.0\n"}};
}

std::vector<CalibrationText> writePose2Sim(const CameraRig& rig, const std::filesystem::path& out) {
  return {{out, camerasText(rig, 4, true) + "[metadata]\nadjusted = false\nerror = 0.0\n"}};
}

} // namespace

CalibrationFormat aniposeFormat() {
  CalibrationFormat format;
  format.name = "anipose";
  format.title = "Anipose or FreeMoCap";
  format.extension = ".toml";
  format.description =
      "5 coefficients or fisheye, camera from world, in the unit of its board, mostly mm";
  format.lensSupport = {5, true};
  format.defaultMetersPerUnit = 0.001;
  format.looksLikeOtherDialect = true;
  format.recognize = recognizeAnipose;
  format.read = readAnipose;
  format.write = writeAnipose;
  return format;
}

CalibrationFormat pose2simFormat() {
  CalibrationFormat format = aniposeFormat();
  format.name = "pose2sim";
  format.title = "Pose2Sim";
  format.description = "4 coefficients, camera from world, meters";
  format.lensSupport = {4, false};
  format.metersPerUnit = 1.0;
  format.defaultMetersPerUnit = 1.0;
  format.recognize = recognizePose2Sim;
  format.write = writePose2Sim;
  return format;
}

} // namespace dewpoint::calibration
