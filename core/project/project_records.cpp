// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_records.h"

#include <array>

namespace dewpoint::project {
namespace {

constexpr std::array<std::pair<const char*, CalibrationOrigin>, 5> kOriginKeys{
    {{"points", CalibrationOrigin::Points},
     {"board", CalibrationOrigin::Board},
     {"wand", CalibrationOrigin::Wand},
     {"file", CalibrationOrigin::File},
     {"marks", CalibrationOrigin::Marks}}};
constexpr double kLargestNumber = 1e9; ///< pixels, meters, radians: larger ones are mistakes

std::optional<CalibrationOrigin> readOrigin(TableReader& reader, const char* key) {
  std::string text;
  reader.readText(key, text);
  if (text.empty()) {
    return std::nullopt;
  }
  const auto known =
      std::ranges::find_if(kOriginKeys, [&](const auto& entry) { return text == entry.first; });
  if (known == kOriginKeys.end()) {
    reader.fail(ErrorCode::BadValue, key, "points, board, wand, file or marks is expected");
    return std::nullopt;
  }
  return known->second;
}

std::optional<double> readNumber(TableReader& reader, const char* key) {
  if (!reader.has(key)) {
    return std::nullopt;
  }
  double value = 0.0;
  reader.readNumber(key, value, 0.0, kLargestNumber);
  return value;
}

std::string originText(const char* key, CalibrationOrigin origin) {
  const auto known = std::ranges::find(kOriginKeys, origin, [](auto& one) { return one.second; });
  return fmt::format("{} = \"{}\"\n", key, known->first);
}

/// An unknown number is left out: a file cannot hold it.
std::string numberLine(const char* key, std::optional<double> value, const char* unit) {
  return value && std::isfinite(*value) ? fmt::format("{} = {}   # {}\n", key, *value, unit) : "";
}

} // namespace

CameraRecord readCameraRecord(TableReader& camera, const std::string& file,
                              const std::string& prefix) {
  CameraRecord record;
  const toml::table* table = camera.findTable("calibrated");
  if (table == nullptr) {
    return record;
  }
  TableReader reader(*table, file, prefix + "calibrated.");
  if (const auto origin = readOrigin(reader, "lens")) {
    LensRecord& lens = record.lens.emplace();
    lens.origin = *origin;
    lens.error = readNumber(reader, "lens_error");
    reader.require("lens_of");
    reader.readNumbers("lens_of", lens.describedIntrinsics.data(), lens.describedIntrinsics.size(),
                       -kLargestNumber, kLargestNumber);
  }
  if (const auto origin = readOrigin(reader, "pose")) {
    PoseRecord& pose = record.pose.emplace();
    pose.origin = *origin;
    pose.error = readNumber(reader, "pose_error");
    reader.require("pose_of");
    reader.readNumbers("pose_of", pose.describedPose.data(), pose.describedPose.size(),
                       -kLargestNumber, kLargestNumber);
  }
  camera.recordError(reader.finish());
  return record;
}

std::string cameraRecordText(const CameraRecord& record) {
  std::string text;
  if (record.lens) {
    text += originText("lens", record.lens->origin) +
            numberLine("lens_error", record.lens->error, "pixels") +
            fmt::format("lens_of = [{}]\n", fmt::join(record.lens->describedIntrinsics, ", "));
  }
  if (record.pose) {
    text += originText("pose", record.pose->origin) +
            numberLine("pose_error", record.pose->error, "meters") +
            fmt::format("pose_of = [{}]\n", fmt::join(record.pose->describedPose, ", "));
  }
  return text.empty() ? text : "[camera.calibrated]   # where these numbers come from\n" + text;
}

WorldRecord readWorldRecord(TableReader& project, const std::string& file) {
  WorldRecord record;
  const toml::table* table = project.findTable("calibrated");
  if (table == nullptr) {
    return record;
  }
  TableReader reader(*table, file, "calibrated.");
  record.scaleOrigin = readOrigin(reader, "scale");
  record.scaleError = readNumber(reader, "scale_error");
  record.floorOrigin = readOrigin(reader, "floor");
  record.errorInsideVolume = readNumber(reader, "accuracy");
  record.errorOutsideVolume = readNumber(reader, "accuracy_outside");
  if (reader.has("length")) {
    std::array<double, 2> length{};
    reader.readNumbers("length", length.data(), length.size(), 0.0, kLargestNumber);
    record.lengthCheck = {length[0], length[1]};
  }
  project.recordError(reader.finish());
  return record;
}

std::string worldRecordText(const WorldRecord& record) {
  std::string text;
  if (record.scaleOrigin) {
    text += originText("scale", *record.scaleOrigin) +
            numberLine("scale_error", record.scaleError, "as a fraction, 95 %");
  }
  if (record.floorOrigin) {
    text += originText("floor", *record.floorOrigin);
  }
  text += numberLine("accuracy", record.errorInsideVolume, "meters, 95 %") +
          numberLine("accuracy_outside", record.errorOutsideVolume,
                     "meters, 95 %, outside the calibrated volume");
  if (record.lengthCheck) {
    text += fmt::format("length = [{}, {}]   # meters: measured with a tape, found in the images\n",
                        record.lengthCheck->measuredLength, record.lengthCheck->calibratedLength);
  }
  return text.empty() ? text : "\n[calibrated]   # where floor and scale come from\n" + text;
}

} // namespace dewpoint::project
