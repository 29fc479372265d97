// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/calibration_check.h"

#include "core/base/text_file.h"
#include "core/calibration/formats/calibration_file.h"
#include "core/calibration/formats/format_catalog.h"
#include "core/calibration/formats/read_calibration.h"
#include "core/setup/calibration/calibration_exchange.h"

#include <algorithm>
#include <utility>

namespace dewpoint::setup {
namespace {

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

} // namespace

CheckedCalibration checkCalibration(const std::filesystem::path& file) {
  CheckedCalibration checked;
  const auto read = readCalibration(file);
  if (!read) {
    AskedQuestion asked = askedQuestion(read.error());
    checked.needsInput = asked.question != ImportQuestion::None;
    checked.problem = std::move(asked.error);
    checked.formatTitle = recognizedTitle(file);
    return checked;
  }
  if (const auto format = calibrationFormat(read->format)) {
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

} // namespace dewpoint::setup
