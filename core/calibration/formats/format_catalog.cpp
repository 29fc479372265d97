// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/format_catalog.h"

#include "core/calibration/formats/format_anipose.h"
#include "core/calibration/formats/format_caliscope.h"
#include "core/calibration/formats/format_dewpoint.h"
#include "core/calibration/formats/format_kalibr.h"
#include "core/calibration/formats/format_mccalib.h"
#include "core/calibration/formats/format_mrcal.h"
#include "core/calibration/formats/format_multical.h"
#include "core/calibration/formats/format_opencv.h"
#include "core/calibration/formats/format_plain.h"
#include "core/calibration/formats/format_qualisys.h"
#include "core/calibration/formats/format_ros.h"

#include <fmt/format.h>

#include <utility>

namespace dewpoint::calibration {

const std::vector<CalibrationFormat>& calibrationFormats() {
  static const std::vector<CalibrationFormat> kFormats = {
      dewpointFormat(),     aniposeFormat(),  pose2simFormat(), caliscopeFormat(), opencvFormat(),
      opencvStereoFormat(), rosFormat(),      kalibrFormat(),   mrcalFormat(),     mcCalibFormat(),
      qualisysFormat(),     multicalFormat(), plainFormat()};
  return kFormats;
}

Result<const CalibrationFormat*> findCalibrationFormat(const std::string& name) {
  std::string names;
  for (const CalibrationFormat& format : calibrationFormats()) {
    if (format.name == name) {
      return &format;
    }
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  }
  return failure(ErrorCode::NotFound, "", name, "the formats are " + names);
}

Result<RecognizedFormat> recognizeFormat(const CalibrationText& source) {
  std::vector<RecognizedFormat> found;
  for (const CalibrationFormat& format : calibrationFormats()) {
    if (std::string reason = format.recognize(source); !reason.empty()) {
      found.push_back({&format, std::move(reason)});
    }
  }
  if (found.size() > 1) { // what has a row of its own is that
    std::erase_if(found, [](const RecognizedFormat& one) { return one.format->isFallback; });
  }
  if (found.size() == 1) {
    return found.front();
  }
  std::string detail = "not a calibration of a known tool";
  if (found.size() > 1) {
    detail = fmt::format("it could be from {} or {}; select one with --from",
                         found[0].format->title, found[1].format->title);
  }
  return failure(ErrorCode::NotParsed, source.file.string(), "", detail);
}

} // namespace dewpoint::calibration
