// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/format_dewpoint.h"

#include "core/base/toml_text.h"
#include "core/calibration/formats/camera_calibration.h"
#include "core/calibration/formats/number_text.h"
#include "core/calibration/formats/toml_cameras.h"

#include <fmt/format.h>

namespace dewpoint::calibration {
namespace {

std::string recognizeDewpoint(const CalibrationText& source) {
  const TomlDialect dialect = recognizeTomlDialect(source);
  if (dialect == TomlDialect::Dewpoint) {
    return "camera tables with size, matrix, rotation and translation, and no other tool's keys";
  }
  // So that a broken file gets its own error.
  return dialect == TomlDialect::None && source.file.extension() == ".toml" &&
                 !hasLineStartingWith(source.text, "[cameras.")
             ? "its ending"
             : "";
}

/// The meters of `[metadata] unit`; nothing when there is none.
Result<std::optional<double>> metadataUnit(const CalibrationText& source) {
  const std::string file = source.file.string();
  const auto table = parseToml(source.text, file);
  const toml::node* unit = table ? table->at_path("metadata.unit").node() : nullptr;
  if (unit == nullptr) {
    return std::optional<double>();
  }
  const std::string name = unit->value_or(std::string());
  if (const auto meters = parseLengthUnit(name)) {
    return meters;
  }
  return failure(ErrorCode::BadValue, file, "metadata.unit",
                 fmt::format("\"{}\" is not a unit of length; expected m, mm, cm, in or ft", name));
}

Result<ParsedCalibration> readDewpoint(const CalibrationText& source, const CalibrationHints&) {
  auto cameras = camerasFromToml(source, {});
  if (!cameras) {
    return tl::make_unexpected(cameras.error());
  }
  const auto unit = metadataUnit(source);
  if (!unit) {
    return tl::make_unexpected(unit.error());
  }
  ParsedCalibration calibration;
  calibration.rig = std::move(*cameras);
  calibration.metersPerUnit = *unit;
  calibration.decisions = {"The poses are stored as camera from world, as in Dewpoint."};
  return calibration;
}

std::vector<CalibrationText> writeDewpoint(const CameraRig& rig, const std::filesystem::path& out) {
  return {{out, calibrationText(rig)}};
}

} // namespace

std::string calibrationText(const CameraRig& rig) {
  std::string text = "# Camera calibration: meters, radians, camera from world (OpenCV axes)\n";
  for (std::size_t k = 0; k < rig.size(); ++k) {
    text += fmt::format("\n[cam_{}]\nname = {}\n", k, tomlQuoted(rig[k].name)) +
            cameraToToml(rig[k], RotationForm::Vector);
  }
  return text + "\n[metadata]\nunit = \"m\"\n";
}

CalibrationFormat dewpointFormat() {
  CalibrationFormat format;
  format.name = "dewpoint";
  format.title = "Dewpoint";
  format.extension = ".toml";
  format.description = "every lens and pose; meters, camera from world";
  format.lensSupport = {8, true};
  format.metersPerUnit = 1.0;
  format.looksLikeOtherDialect = true;
  format.recognize = recognizeDewpoint;
  format.read = readDewpoint;
  format.write = writeDewpoint;
  return format;
}

} // namespace dewpoint::calibration
