// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/read_calibration.h"

#include "core/base/limits.h"
#include "core/base/text_file.h"
#include "core/calibration/formats/calibration_plausibility.h"
#include "core/calibration/formats/format_catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::calibration {
namespace {

/// mrcal keeps all that a calibration was made from under this key, and may be large.
constexpr const char* kInputs = "optimization_inputs";

/// The format a person named, or the one the content shows; adds the sentence why.
Result<const CalibrationFormat*> formatOf(const CalibrationText& source,
                                          const CalibrationHints& hints, std::string& reason) {
  const auto recognized = recognizeFormat(source);
  if (hints.format.empty()) {
    if (!recognized) {
      return tl::make_unexpected(recognized.error());
    }
    reason =
        fmt::format("Read as {}, recognized by {}.", recognized->format->title, recognized->reason);
    return recognized->format;
  }
  const auto requested = findCalibrationFormat(hints.format);
  if (!requested) {
    return requested;
  }
  // Dialects that share their keys: a person may know better.
  if (recognized && recognized->format != *requested &&
      !(recognized->format->looksLikeOtherDialect && (*requested)->looksLikeOtherDialect)) {
    return failure(ErrorCode::Mismatch, source.file.string(), "",
                   fmt::format("it looks like a file of {} (recognized by {}), not of {}",
                               recognized->format->title, recognized->reason, (*requested)->title));
  }
  if (!recognized) {
    return failure(ErrorCode::NotParsed, source.file.string(), "",
                   fmt::format("it does not look like a file of {}", (*requested)->title));
  }
  reason = fmt::format("Read as {}, as requested.", (*requested)->title);
  return requested;
}

std::string unitSentence(double unit) {
  return unit == 1.0 ? "Lengths are meters." : fmt::format("Lengths are in units of {} m.", unit);
}

/// Brings the lengths to meters: as asked, else as the format says, else it is an error.
Status toMeters(const CalibrationFormat& format, const CalibrationHints& hints,
                const std::string& file, ParsedCalibration& calibration) {
  if (!calibration.hasPoses) {
    return {};
  }
  const auto known = calibration.metersPerUnit ? calibration.metersPerUnit : format.metersPerUnit;
  if (known && hints.metersPerUnit && std::abs(*hints.metersPerUnit / *known - 1.0) > 1e-9) {
    return failure(
        ErrorCode::BadValue, file, "unit",
        fmt::format(
            "{} was requested, but the lengths of this file are in units of {} m; omit the unit",
            *hints.metersPerUnit, *known));
  }
  const auto unit = known ? known : hints.metersPerUnit;
  const double spread = cameraSpread(calibration.rig);
  if (!unit) {
    return failure(
        ErrorCode::MissingKey, file, "unit",
        fmt::format("files of {} do not contain their unit. The cameras are up to {} units apart, "
                    "so the unit is probably {}: convert the file with --unit mm, --unit m, or the "
                    "length of one unit in meters",
                    format.title,
                    spread >= 100.0 ? fmt::format("{:.0f}", spread) : fmt::format("{:.3g}", spread),
                    likelyUnit(spread)));
  }
  for (Camera& camera : calibration.rig) {
    camera.cameraFromWorld.translation() *= *unit;
  }
  calibration.metersPerUnit = 1.0;
  calibration.decisions.push_back(unitSentence(*unit));
  return {};
}

Status finish(const CalibrationFormat& format, const CalibrationHints& hints,
              const std::string& file, ParsedCalibration& calibration) {
  calibration.format = format.name;
  if (hints.posesAreWorldFromCamera.value_or(false)) {
    calibration.rig = withInvertedPoses(std::move(calibration.rig));
    calibration.decisions.emplace_back("The poses were inverted, as requested.");
  }
  if (auto status = toMeters(format, hints, file, calibration); !status) {
    return status;
  }
  if (!calibration.hasPoses) {
    if (calibration.rig.size() > 1) {
      return failure(
          ErrorCode::MissingKey, file, "pose",
          fmt::format("these files contain {} cameras, but no poses", calibration.rig.size()));
    }
    calibration.decisions.emplace_back(
        "The file contains no pose, so the axes of the camera are the world.");
  }
  return checkPlausibility(calibration, hints, file);
}

Result<ParsedCalibration> readOne(const CalibrationText& source, const CalibrationHints& hints,
                                  const CalibrationFormat*& format) {
  std::string reason;
  const auto known = formatOf(source, hints, reason);
  if (!known) {
    return tl::make_unexpected(known.error());
  }
  format = *known;
  auto calibration = format->read(source, hints);
  if (calibration) {
    calibration->decisions.insert(calibration->decisions.begin(), reason);
  }
  return calibration;
}

Result<CalibrationText> readSource(const std::filesystem::path& file) {
  auto text = readTextFile(file);
  if (!text) {
    return tl::make_unexpected(text.error());
  }
  if (text->size() > limits::kMaxCalibrationBytes && text->find(kInputs) == std::string::npos) {
    return failure(ErrorCode::NotParsed, file.string(), "", "too large for a calibration");
  }
  return CalibrationText{file, std::move(*text)};
}

/// "cam2" before "cam10": by length of the number, as people count.
bool numericLess(const std::filesystem::path& a, const std::filesystem::path& b) {
  const std::string one = a.filename().string();
  const std::string other = b.filename().string();
  const auto [i, j] = std::ranges::mismatch(one, other);
  const auto digits = [](auto at, auto end) {
    return std::find_if(at, end, [](char letter) { return letter < '0' || letter > '9'; }) - at;
  };
  const auto here = digits(i, one.end());
  const auto there = digits(j, other.end());
  return here != there && (here > 0 || there > 0) ? here < there : one < other;
}

/// Whether a file of a folder may be read, by its name: not each of them is a calibration.
bool mayBeOfFolder(const std::filesystem::path& file) {
  const auto extension = file.extension();
  return extension == ".yaml" || extension == ".yml" || extension == ".json" ||
         extension == ".cameramodel";
}

/// The files of a folder that are calibrations of a camera each, in the order people count them; or
/// one of the two files of a pair, which names the other.
Result<std::vector<CalibrationText>> folderSources(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code problem;
  for (const auto& entry : std::filesystem::directory_iterator(folder, problem)) {
    if (entry.is_regular_file(problem) && mayBeOfFolder(entry.path())) {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files, numericLess);
  std::vector<CalibrationText> sources;
  std::vector<CalibrationText> pair;
  for (const auto& file : files) {
    auto source = readSource(file);
    if (!source) {
      return tl::make_unexpected(source.error());
    }
    const auto recognized = recognizeFormat(*source);
    if (recognized && recognized->format->layout == FileLayout::FilePerCamera) {
      sources.push_back(std::move(*source));
    } else if (recognized && recognized->format->layout == FileLayout::CameraPair) {
      pair.push_back(std::move(*source));
    }
  }
  if (sources.empty() && pair.size() > 2) {
    return failure(ErrorCode::Mismatch, folder.string(), pair[2].file.filename().string(),
                   "there is more than one pair of cameras in the folder: choose one of the files");
  }
  if (sources.empty() && !pair.empty()) {
    sources.push_back(std::move(pair.front()));
  }
  if (sources.empty()) {
    return failure(ErrorCode::NotFound, folder.string(), "",
                   "a folder is expected to hold a calibration file per camera (camera_info, "
                   ".cameramodel, OpenCV YAML, or K with R and t), or intrinsics.yml and "
                   "extrinsics.yml of a pair");
  }
  return sources;
}

/// One file of a folder, as it was read.
struct FolderPart {
  std::string file; ///< its name
  ParsedCalibration calibration;
};

/// Where only some files of a folder state their unit, the others take the requested one: no file
/// decides for another one. MissingKey names a file without a unit.
Status giveUnits(const std::string& folder, const CalibrationHints& hints,
                 std::vector<FolderPart>& parts) {
  const auto hasUnit = [](const FolderPart& part) {
    return part.calibration.metersPerUnit.has_value();
  };
  const bool isMixed = std::ranges::any_of(parts, hasUnit) && !std::ranges::all_of(parts, hasUnit);
  for (FolderPart& part : parts) {
    if (!isMixed || hasUnit(part) || !part.calibration.hasPoses) {
      continue;
    }
    if (!hints.metersPerUnit) {
      return failure(ErrorCode::MissingKey, folder, part.file + ": unit",
                     "this file does not state its unit, although others in the folder do: specify "
                     "it with --unit mm, m or the meters of one unit");
    }
    part.calibration.metersPerUnit = *hints.metersPerUnit;
    part.calibration.decisions.push_back(fmt::format(
        "{}: lengths are in units of {} m, as requested.", part.file, *hints.metersPerUnit));
  }
  return {};
}

void append(ParsedCalibration& whole, ParsedCalibration&& part) {
  if (part.metersPerUnit && whole.metersPerUnit) { // each file may have its own
    for (Camera& camera : part.rig) {
      camera.cameraFromWorld.translation() *= *part.metersPerUnit / *whole.metersPerUnit;
    }
  }
  whole.metersPerUnit = whole.metersPerUnit ? whole.metersPerUnit : part.metersPerUnit;
  std::ranges::move(part.rig, std::back_inserter(whole.rig));
  whole.hasPoses = whole.hasPoses && part.hasPoses;
  for (std::string& decision : part.decisions) {
    if (std::ranges::find(whole.decisions, decision) == whole.decisions.end()) {
      whole.decisions.push_back(std::move(decision));
    }
  }
}

} // namespace

Result<ParsedCalibration> readCalibration(const std::filesystem::path& path,
                                          const CalibrationHints& hints) {
  std::error_code problem;
  Result<std::vector<CalibrationText>> sources;
  if (std::filesystem::is_directory(path, problem)) {
    sources = folderSources(path);
  } else {
    sources = readSource(path).map(
        [](CalibrationText source) { return std::vector<CalibrationText>{std::move(source)}; });
  }
  if (!sources) {
    return tl::make_unexpected(sources.error());
  }
  std::vector<FolderPart> parts;
  const CalibrationFormat* format = nullptr;
  for (const CalibrationText& source : *sources) {
    const CalibrationFormat* before = format;
    auto part = readOne(source, hints, format);
    if (!part) {
      return tl::make_unexpected(part.error());
    }
    if (before != nullptr && before != format) {
      return failure(ErrorCode::Mismatch, path.string(), source.file.filename().string(),
                     fmt::format("the folder contains files of {} and of {}; put only files of one "
                                 "program into a folder",
                                 before->title, format->title));
    }
    parts.push_back({source.file.filename().string(), std::move(*part)});
  }
  const bool isUnitOfEach = std::ranges::all_of(
      parts, [](const auto& part) { return part.calibration.metersPerUnit.has_value(); });
  if (const auto given = giveUnits(path.string(), hints, parts); !given) {
    return tl::make_unexpected(given.error());
  }
  ParsedCalibration whole;
  for (FolderPart& part : parts) {
    append(whole, std::move(part.calibration));
  }
  CalibrationHints remaining = hints;
  if (whole.metersPerUnit && !isUnitOfEach) {
    remaining.metersPerUnit.reset(); // it was for the files without one
  }
  if (const auto status = finish(*format, remaining, path.string(), whole); !status) {
    return tl::make_unexpected(status.error());
  }
  return whole;
}

} // namespace dewpoint::calibration
