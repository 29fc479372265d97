// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/calibration_check.h"

#include "core/base/lower_case.h"
#include "core/base/text_file.h"
#include "core/calibration/formats/calibration_file.h"
#include "core/calibration/formats/format_catalog.h"
#include "core/calibration/formats/number_text.h"
#include "core/calibration/formats/read_calibration.h"
#include "core/setup/calibration/calibration_exchange.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace dewpoint::setup {
namespace {

namespace fs = std::filesystem;

/// The format of a file that cannot be read as a calibration; empty: none that is known.
std::string recognizedTitle(const std::filesystem::path& file) {
  std::error_code problem;
  if (!std::filesystem::is_regular_file(file, problem)) {
    return {};
  }
  const auto text = readTextFile(file);
  const auto recognized = text.and_then([&](const std::string& read) {
    return recognizeFormat({file, read});
  });
  return recognized ? recognized->format->title : std::string();
}

constexpr std::size_t kMostCandidates = 64;
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 20U; ///< larger files are no calibration

bool hasCalibrationEnding(const fs::path& file) {
  const std::string name = toLowerCase(file.filename().string());
  const auto ends = [&](std::string_view ending) { return name.ends_with(ending); };
  return ends(".yml") || ends(".yaml") || // YAML has two, whichever a format names
         std::ranges::any_of(calibrationFormats(), [&](const CalibrationFormat& format) {
           return ends(format.extension) || std::ranges::any_of(format.otherExtensions, ends);
         });
}

/// A project holds the calibration of its cameras, but it is another project's.
bool isProjectFile(const fs::path& file) {
  const auto text = readTextFile(file);
  return text &&
         (hasLineStartingWith(*text, "format = ") || hasLineStartingWith(*text, "[[camera"));
}

/// The files in a folder that could be calibrations; empty if there are too many to read.
std::vector<fs::path> candidatesIn(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code problem;
  std::error_code unread; // the rest of a disk that gives up
  for (fs::directory_iterator entry(folder, unread); !unread && entry != fs::directory_iterator();
       entry.increment(unread)) {
    if (hasCalibrationEnding(entry->path()) && entry->is_regular_file(problem) &&
        entry->file_size(problem) <= kMostBytes) {
      found.push_back(entry->path());
    }
    if (found.size() > kMostCandidates) {
      return {};
    }
  }
  return found;
}

} // namespace

CheckedCalibration checkCalibration(const std::filesystem::path& file) {
  CheckedCalibration checked;
  const auto read = readCalibration(file);
  if (!read) {
    ImportProblem asked = importProblem(read.error());
    checked.needsInput = asked.question != ImportQuestion::None;
    checked.problem = std::move(asked.error);
    checked.formatTitle = recognizedTitle(file);
    return checked;
  }
  if (const auto format = findCalibrationFormat(read->format)) {
    checked.formatTitle = (*format)->title;
  }
  if (!read->hasPoses) {
    checked.problem = loadCalibration(file).error();
    return checked;
  }
  for (const Camera& camera : read->rig) {
    checked.cameras.push_back(camera.name);
  }
  return checked;
}

CameraMatch matchCameras(const std::vector<std::string>& cameras,
                         const std::vector<std::string>& inFile) {
  const auto found = std::ranges::count_if(cameras, [&](const std::string& name) {
    return std::ranges::find(inFile, name) != inFile.end();
  });
  if (found == std::ssize(cameras)) {
    return CameraMatch::ByName;
  }
  return found == 0 && cameras.size() == inFile.size() ? CameraMatch::ByOrder : CameraMatch::None;
}

std::optional<fs::path> calibrationFileBeside(const std::vector<std::string>& recordings,
                                              const std::vector<std::string>& cameras) {
  std::set<fs::path> folders;
  std::error_code problem;
  for (const std::string& recording : recordings) {
    if (fs::exists(recording, problem) && !recording.starts_with("/dev/")) {
      folders.insert(fs::absolute(recording, problem).lexically_normal().parent_path());
    }
  }
  std::vector<fs::path> byName;
  std::vector<fs::path> byOrder;
  for (const fs::path& folder : folders) {
    for (const fs::path& file : candidatesIn(folder)) {
      const CheckedCalibration checked = checkCalibration(file);
      const CameraMatch match =
          checked.problem ? CameraMatch::None : matchCameras(cameras, checked.cameras);
      if (match == CameraMatch::None || isProjectFile(file)) {
        continue;
      }
      (match == CameraMatch::ByName ? byName : byOrder).push_back(file);
    }
  }
  const std::vector<fs::path>& best = byName.empty() ? byOrder : byName;
  return best.size() == 1 ? std::optional(best.front()) : std::nullopt;
}

} // namespace dewpoint::setup
