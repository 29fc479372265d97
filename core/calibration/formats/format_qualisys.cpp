// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/format_qualisys.h"

#include "core/base/lower_case.h"
#include "core/base/markup.h"
#include "core/calibration/formats/camera_limit.h"
#include "core/calibration/formats/camera_parts.h"
#include "core/calibration/formats/number_text.h"

#include <fmt/format.h>

#include <pugixml.hpp>

namespace dewpoint::calibration {
namespace {

/// The format counts in 1/64 pixels.
constexpr double kUnitsPerPixel = 64.0;

std::string recognizeQualisys(const CalibrationText& source) {
  return source.text.find("<calibration") != std::string::npos &&
                 source.text.find("focalLengthU") != std::string::npos
             ? "XML <calibration> with focalLengthU"
             : "";
}

/// Takes numbers out of attributes and keeps the first that is missing or none.
class AttributeReader {
public:
  AttributeReader(std::string file, std::string prefix)
      : file_(std::move(file)), prefix_(std::move(prefix)) {}

  double number(const pugi::xml_node& node, const char* element, const char* name) {
    const pugi::xml_attribute attribute = node.child(element).attribute(name);
    const auto value = parseNumber(attribute.value());
    if (!value && !error_) {
      error_ = Error{attribute.empty() ? ErrorCode::MissingKey : ErrorCode::WrongType, file_,
                     field(element) + "." + name, attribute.empty() ? "" : "a number is expected"};
    }
    return value.value_or(0.0);
  }

  std::string field(const std::string& element) const { return prefix_ + element; }
  const std::optional<Error>& error() const { return error_; }

private:
  std::string file_;
  std::string prefix_;
  std::optional<Error> error_;
};

/// Half a turn about x: Qualisys' cameras look along -z with y up, OpenCV's along z with y down.
Eigen::Matrix3d halfTurn() {
  return Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
}

void readQualisysLens(const pugi::xml_node& camera, AttributeReader& reader, CameraParts& parts) {
  const auto video = [&](const char* name) { return reader.number(camera, "fov_video", name); };
  const auto lens = [&](const char* name) { return reader.number(camera, "intrinsic", name); };
  const double left = video("left");
  const double top = video("top");
  parts.width = video("right") - left + 1.0;
  parts.height = video("bottom") - top + 1.0;
  parts.matrix = matrixOf(
      lens("focalLengthU") / kUnitsPerPixel, lens("focalLengthV") / kUnitsPerPixel,
      lens("centerPointU") / kUnitsPerPixel - left, lens("centerPointV") / kUnitsPerPixel - top);
  parts.distortion = {lens("radialDistortion1"), lens("radialDistortion2"),
                      lens("tangentalDistortion1"), lens("tangentalDistortion2"),
                      lens("radialDistortion3")};
}

/// `transform` is world from camera, its rotation listed column by column.
void readQualisysPose(const pugi::xml_node& camera, AttributeReader& reader, CameraParts& parts) {
  const auto value = [&](const char* name) { return reader.number(camera, "transform", name); };
  Eigen::Matrix3d cameraFromWorld;
  cameraFromWorld << value("r11"), value("r12"), value("r13"), value("r21"), value("r22"),
      value("r23"), value("r31"), value("r32"), value("r33");
  parts.rotation = halfTurn() * cameraFromWorld;
  parts.translation = -(parts.rotation * Eigen::Vector3d(value("x"), value("y"), value("z")));
}

/// Markers' cameras are in the same file; only those that make video matter here.
bool isVideoCamera(const pugi::xml_node& camera) {
  const std::string model = toLowerCase(camera.attribute("model").value());
  return model.find("video") != std::string::npos || model.empty() || model == "none";
}

Result<Camera> readQualisysCamera(const pugi::xml_node& node, const std::string& file) {
  CameraParts parts;
  parts.name = node.attribute("serial").value();
  AttributeReader reader(file, fmt::format("camera {}.", parts.name));
  readQualisysLens(node, reader, parts);
  readQualisysPose(node, reader, parts);
  if (reader.error()) {
    return tl::make_unexpected(*reader.error());
  }
  return checkedCamera(parts, file,
                       {reader.field("fov_video"), reader.field("intrinsic"),
                        reader.field("intrinsic"), reader.field("transform"),
                        reader.field("transform")});
}

Result<ParsedCalibration> readQualisys(const CalibrationText& source, const CalibrationHints&) {
  const std::string file = source.file.string();
  pugi::xml_document document;
  const auto parsed = document.load_buffer(source.text.data(), source.text.size());
  if (!parsed) {
    return failure(ErrorCode::NotParsed, file, fmt::format("byte {}", parsed.offset),
                   parsed.description());
  }
  ParsedCalibration calibration;
  calibration.decisions = {
      "The rotation was read column by column and turned by 180 degrees about x, because Qualisys' "
      "cameras look along -z.",
      "Intrinsics are in 1/64 pixels, shifted by the left and top of fov_video; distortion as it "
      "is "
      "(Pose2Sim divides it by 64 too)."};
  int markerCameras = 0;
  for (const pugi::xml_node& node : document.child("calibration").child("cameras")) {
    if (!isVideoCamera(node)) {
      ++markerCameras;
      continue;
    }
    auto camera = readQualisysCamera(node, file);
    if (!camera) {
      return tl::make_unexpected(camera.error());
    }
    if (calibration.rig.size() == limits::kMaxCameras) {
      return tooManyCamerasError(file);
    }
    calibration.rig.push_back(std::move(*camera));
  }
  if (markerCameras > 0) {
    calibration.decisions.push_back(
        fmt::format("{} cameras that make no video were left out.", markerCameras));
  }
  if (calibration.rig.empty()) {
    return failure(ErrorCode::MissingKey, file, "calibration.cameras.camera",
                   "the file holds no video camera");
  }
  return calibration;
}

std::string attributes(std::initializer_list<std::pair<const char*, double>> values) {
  std::string text;
  for (const auto& [name, value] : values) {
    text += fmt::format(" {}=\"{}\"", name, numberText(value));
  }
  return text;
}

std::string qualisysCameraText(const Camera& camera) {
  const auto& in = camera.intrinsics;
  const auto& d = camera.distortion;
  const Eigen::Matrix3d r = halfTurn() * camera.cameraFromWorld.linear();
  const Eigen::Vector3d at = camera.center();
  return fmt::format("    <camera active=\"1\" avg-residual=\"0.0\" serial=\"{}\" "
                     "model=\"Video\" viewrotation=\"0\">\n",
                     htmlEscaped(camera.name)) +
         fmt::format("      <fov_video left=\"0\" top=\"0\" right=\"{}\" bottom=\"{}\"/>\n",
                     in.width - 1, in.height - 1) +
         "      <transform" +
         attributes({{"x", at.x()},
                     {"y", at.y()},
                     {"z", at.z()},
                     {"r11", r(0, 0)},
                     {"r12", r(0, 1)},
                     {"r13", r(0, 2)},
                     {"r21", r(1, 0)},
                     {"r22", r(1, 1)},
                     {"r23", r(1, 2)},
                     {"r31", r(2, 0)},
                     {"r32", r(2, 1)},
                     {"r33", r(2, 2)}}) +
         "/>\n      <intrinsic" +
         attributes({{"sensorMinU", 0.0},
                     {"sensorMaxU", in.width * kUnitsPerPixel - 1.0},
                     {"sensorMinV", 0.0},
                     {"sensorMaxV", in.height * kUnitsPerPixel - 1.0},
                     {"focalLengthU", in.focalX * kUnitsPerPixel},
                     {"focalLengthV", in.focalY * kUnitsPerPixel},
                     {"centerPointU", in.centerX * kUnitsPerPixel},
                     {"centerPointV", in.centerY * kUnitsPerPixel},
                     {"skew", 0.0},
                     {"radialDistortion1", d[0]},
                     {"radialDistortion2", d[1]},
                     {"radialDistortion3", d[4]},
                     {"tangentalDistortion1", d[2]},
                     {"tangentalDistortion2", d[3]}}) +
         "/>\n    </camera>\n";
}

std::vector<CalibrationText> writeQualisys(const CameraRig& rig, const std::filesystem::path& out) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<calibration>\n  <cameras>\n";
  for (const Camera& camera : rig) {
    text += qualisysCameraText(camera);
  }
  return {{out, text + "  </cameras>\n</calibration>\n"}};
}

} // namespace

CalibrationFormat qualisysFormat() {
  CalibrationFormat format;
  format.name = "qualisys";
  format.title = "Qualisys";
  format.extension = ".qca.txt";
  format.description =
      "5 coefficients, world from camera with cameras that look along -z, mm, 1/64 pixels";
  format.lensSupport = {5, false};
  format.metersPerUnit = 0.001;
  format.defaultMetersPerUnit = 0.001;
  format.recognize = recognizeQualisys;
  format.read = readQualisys;
  format.write = writeQualisys;
  return format;
}

} // namespace dewpoint::calibration
