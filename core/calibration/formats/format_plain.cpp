// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/format_plain.h"

#include "core/calibration/formats/camera_limit.h"
#include "core/calibration/formats/camera_parts.h"
#include "core/calibration/formats/yaml_reader.h"
#include "core/geometry/rotation_vector.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

namespace dewpoint::calibration {
namespace {

constexpr const char* kMatrixKeys[] = {"K", "camera_matrix", "intrinsic_matrix", "mtx", "matrix"};
constexpr const char* kLensKeys[] = {"dist", "distortion", "distortion_coefficients", "dist_coeffs",
                                     "D"};
constexpr const char* kRotationKeys[] = {"R", "rvec", "rotation", "rotation_matrix",
                                         "rotation_vector"};
constexpr const char* kTranslationKeys[] = {"t", "T", "tvec", "translation", "translation_vector"};
constexpr const char* kSizeKeys[] = {"image_size", "size", "resolution"};
constexpr std::pair<const char*, const char*> kSideKeys[] = {{"width", "height"},
                                                             {"image_width", "image_height"}};
using KeyNames = std::span<const char* const>;

/// Whether a JSON or YAML text has a key, looking at the text alone.
bool textHasKey(std::string_view text, std::string_view key) {
  constexpr std::string_view kBefore = " \t\r\n\"'{,-";
  constexpr std::string_view kBlank = " \t\"'";
  for (auto at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
    const bool begins = at == 0 || kBefore.find(text[at - 1]) != std::string_view::npos;
    const auto after = text.find_first_not_of(kBlank, at + key.size());
    if (begins && after != std::string_view::npos && text[after] == ':') {
      return true;
    }
  }
  return false;
}

bool textHasOneOf(std::string_view text, KeyNames keys) {
  return std::ranges::any_of(keys, [&](const char* key) { return textHasKey(text, key); });
}

std::string recognizePlain(const CalibrationText& source) {
  const bool isCamera =
      textHasOneOf(source.text, kMatrixKeys) &&
      (textHasOneOf(source.text, kLensKeys) || textHasOneOf(source.text, kRotationKeys) ||
       textHasOneOf(source.text, kTranslationKeys));
  return isCamera ? "a camera matrix with distortion, R or t" : "";
}

/// The key that a mapping has; null: none of them.
const char* keyIn(const YamlReader& reader, KeyNames keys) {
  const auto found = std::ranges::find_if(keys, [&](const char* key) { return reader.has(key); });
  return found == keys.end() ? nullptr : *found;
}

/// A camera's mapping in the file.
struct CameraSection {
  YAML::Node node;
  std::string name;
  std::string prefix; ///< of the names of its fields in errors
};

bool isSection(const YAML::Node& node) {
  return node.IsDefined() && node.IsMap() && keyIn(YamlReader(node, ""), kMatrixKeys) != nullptr;
}

/// The cameras in a list, or those in a mapping under their names; other entries are ignored.
Result<std::vector<CameraSection>> sectionsIn(const YAML::Node& node, const std::string& file) {
  constexpr std::size_t kMostEntries = 2 * limits::kMaxCameras; // each is looked through
  if (node.size() > kMostEntries) {
    return failure(ErrorCode::BadValue, file, "",
                   fmt::format("at most {} entries are possible", kMostEntries));
  }
  std::vector<CameraSection> sections;
  for (const auto& item : node) {
    const bool isListed = node.IsSequence();
    const std::string number = fmt::format("camera {}", sections.size() + 1);
    const bool isNamed = !isListed && item.first.IsDefined() && item.first.IsScalar();
    const YAML::Node camera = isListed ? YAML::Node(item) : item.second;
    if (!isSection(camera)) {
      if (isListed) {
        return failure(ErrorCode::MissingKey, file, number + ".K", "");
      }
      continue;
    }
    if (sections.size() == limits::kMaxCameras) {
      return tooManyCamerasError(file);
    }
    const std::string name = isNamed ? item.first.Scalar() : number;
    sections.push_back({camera, YamlReader(camera, file).text("name", name), name + "."});
  }
  if (sections.empty()) {
    return failure(ErrorCode::MissingKey, file, "K", "no camera with a camera matrix was found");
  }
  return sections;
}

Result<std::vector<CameraSection>> sectionsOf(const YAML::Node& root,
                                              const std::filesystem::path& file) {
  if (isSection(root)) {
    const std::string name = YamlReader(root, "").text("name", file.stem().string());
    return std::vector<CameraSection>{{root, name, ""}};
  }
  if (root.IsMap()) {
    for (const auto& item : root) {
      if (item.first.IsScalar() && item.first.Scalar() == "cameras" &&
          (item.second.IsMap() || item.second.IsSequence())) {
        return sectionsIn(item.second, file.string());
      }
    }
  }
  return sectionsIn(root, file.string());
}

/// A pixel size from the file or the hints; the name of its field.
std::string readPlainSize(const YamlReader& reader, const CalibrationHints& hints,
                          CameraParts& parts) {
  if (const char* key = keyIn(reader, kSizeKeys)) {
    const auto size = reader.numbers(key, {2});
    parts.width = size[0];
    parts.height = size[1];
    return key;
  }
  for (const auto& [width, height] : kSideKeys) {
    if (reader.has(width)) {
      parts.width = reader.number(width);
      parts.height = reader.number(height);
      return width;
    }
  }
  if (hints.imageSize) {
    parts.width = (*hints.imageSize)[0];
    parts.height = (*hints.imageSize)[1];
  } else {
    reader.fail(ErrorCode::MissingKey, "image_size",
                "the file does not contain the image size; convert with --size WIDTHxHEIGHT");
  }
  return "image_size";
}

/// Row by row, or column by column as Open3D writes it: the last row says which.
void readPlainMatrix(const YamlReader& reader, const char* key, ParsedCalibration& calibration,
                     CameraParts& parts) {
  parts.matrix = reader.matrix(key, 3, 3);
  const auto& matrix = parts.matrix;
  if (matrix(0, 2) == 0.0 && matrix(1, 2) == 0.0 && (matrix(2, 0) != 0.0 || matrix(2, 1) != 0.0)) {
    parts.matrix.transposeInPlace();
    calibration.decisions.emplace_back("Camera matrices are written column by column.");
  }
}

void readPlainLens(const YamlReader& reader, const char* key, const CalibrationHints& hints,
                   CameraParts& parts) {
  if (key != nullptr) {
    parts.distortion = reader.numbers(key, {4, 5, 0, 2, 8, 12, 14});
  }
  const bool saysFisheye = reader.text("model") == "fisheye" || reader.text("fisheye") == "true";
  const bool isZero =
      std::ranges::all_of(parts.distortion, [](double value) { return value == 0.0; });
  if (hints.lens == LensModel::Fisheye || (saysFisheye && !hints.lens)) {
    parts.lens = LensModel::Fisheye;
    if (parts.distortion.empty()) {
      parts.distortion.assign(4, 0.0);
    }
  } else if (parts.distortion.size() == 4 && !isZero && !hints.lens && !reader.has("model") &&
             !reader.has("fisheye")) {
    reader.fail(ErrorCode::BadValue, key,
                "four coefficients are k1 k2 p1 p2 of a pinhole, or k1 k2 k3 k4 of a fisheye; "
                "convert with --lens pinhole or --lens fisheye");
  }
}

/// Whether there is a pose. A rotation without a translation, or the other way round, is an error.
bool readPlainPose(const YamlReader& reader, const char* rotation, const char* translation,
                   CameraParts& parts) {
  if (rotation == nullptr && translation == nullptr) {
    return false;
  }
  if (rotation == nullptr || translation == nullptr) {
    reader.fail(ErrorCode::MissingKey, rotation == nullptr ? "R" : "t", "");
    return false;
  }
  const auto values = reader.numbers(rotation, {9, 3});
  if (values.size() == 3) {
    parts.rotation = rotationFromVector({values[0], values[1], values[2]});
  } else {
    parts.rotation = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values.data());
  }
  parts.translation = reader.matrix(translation, 3, 1);
  return true;
}

Result<Camera> readSection(const CameraSection& section, const std::string& file,
                           const CalibrationHints& hints, ParsedCalibration& calibration) {
  const YamlReader reader(section.node, file, section.prefix);
  const char* matrix = keyIn(reader, kMatrixKeys);
  const char* lens = keyIn(reader, kLensKeys);
  const char* rotation = keyIn(reader, kRotationKeys);
  const char* translation = keyIn(reader, kTranslationKeys);
  CameraParts parts;
  parts.name = section.name;
  readPlainMatrix(reader, matrix, calibration, parts);
  readPlainLens(reader, lens, hints, parts);
  calibration.hasPoses =
      readPlainPose(reader, rotation, translation, parts) && calibration.hasPoses;
  const std::string size = readPlainSize(reader, hints, parts);
  if (reader.error()) {
    return tl::make_unexpected(*reader.error());
  }
  const auto field = [&](const char* key) { return reader.fieldPath(key != nullptr ? key : ""); };
  return checkedCamera(
      parts, file,
      {field(size.c_str()), field(matrix), field(lens), field(rotation), field(translation)});
}

Result<ParsedCalibration> readPlain(const CalibrationText& source, const CalibrationHints& hints) {
  const std::string file = source.file.string();
  const auto root = parseYaml(source.text, file); // JSON is YAML
  if (!root) {
    return tl::make_unexpected(root.error());
  }
  const auto sections = sectionsOf(*root, source.file);
  if (!sections) {
    return tl::make_unexpected(sections.error());
  }
  ParsedCalibration calibration;
  const YamlReader whole(*root, file);
  if (const std::string unit = whole.text("unit"); !unit.empty()) {
    calibration.metersPerUnit = parseLengthUnit(unit);
    if (!calibration.metersPerUnit) {
      return failure(ErrorCode::BadValue, file, "unit",
                     "m, mm, cm, in, ft or the meters of one unit are expected");
    }
  }
  for (const CameraSection& section : *sections) {
    auto camera = readSection(section, file, hints, calibration);
    if (!camera) {
      return tl::make_unexpected(camera.error());
    }
    calibration.rig.push_back(std::move(*camera));
  }
  if (calibration.hasPoses) {
    calibration.decisions.emplace_back("R and t lead from the world to the camera.");
  }
  auto& decisions = calibration.decisions;
  decisions.erase(std::unique(decisions.begin(), decisions.end()), // of several cameras
                  decisions.end());
  return calibration;
}

} // namespace

bool hasPlainPose(const std::string& text) {
  return textHasOneOf(text, kRotationKeys) && textHasOneOf(text, kTranslationKeys);
}

CalibrationFormat plainFormat() {
  CalibrationFormat format;
  format.name = "plain";
  format.title = "K, distortion, R and t";
  format.extension = ".json";
  format.otherExtensions = {".yaml", ".yml"};
  format.description =
      "8 coefficients or fisheye, one camera, or several in a list or by name, camera "
      "from world, with an image size and a unit if they were written";
  format.layout = FileLayout::FilePerCamera;
  format.lensSupport = {8, true};
  format.isFallback = true;
  format.recognize = recognizePlain;
  format.read = readPlain;
  return format;
}

} // namespace dewpoint::calibration
