// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/calibration_format.h"

#include "core/calibration/formats/format_anipose.h"
#include "core/calibration/formats/format_caliscope.h"
#include "core/calibration/formats/format_dewpoint.h"
#include "core/calibration/formats/format_kalibr.h"
#include "core/calibration/formats/format_mccalib.h"
#include "core/calibration/formats/format_mrcal.h"
#include "core/calibration/formats/format_multical.h"
#include "core/calibration/formats/format_opencv.h"
#include "core/calibration/formats/format_qualisys.h"
#include "core/calibration/formats/format_ros.h"
#include "core/calibration/formats/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::calibration {

const std::vector<CalibrationFormat>& calibrationFormats() {
  static const std::vector<CalibrationFormat> kFormats = {
      dewpointFormat(), aniposeFormat(),      pose2simFormat(), caliscopeFormat(),
      opencvFormat(),   opencvStereoFormat(), rosFormat(),      kalibrFormat(),
      mrcalFormat(),    mcCalibFormat(),      qualisysFormat(), multicalFormat()};
  return kFormats;
}

std::optional<double> metersOfUnit(const std::string& text) {
  for (const auto& [name, meters] :
       {std::pair("m", 1.0), std::pair("mm", 0.001), std::pair("cm", 0.01), std::pair("in", 0.0254),
        std::pair("ft", 0.3048)}) {
    if (text == name) {
      return meters;
    }
  }
  const auto meters = numberOf(text);
  return meters && *meters > 0.0 && std::isfinite(*meters) ? meters : std::nullopt;
}

Result<const CalibrationFormat*> calibrationFormat(const std::string& name) {
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
  if (found.size() == 1) {
    return found.front();
  }
  std::string detail = "no calibration of a tool that is known here";
  if (found.size() > 1) {
    detail = fmt::format("it may be of {} or of {}; say which with --from", found[0].format->title,
                         found[1].format->title);
  }
  return failure(ErrorCode::NotParsed, source.file.string(), "", detail);
}

std::filesystem::path cameraFile(const CameraRig& rig, std::size_t camera,
                                 const std::filesystem::path& out, const char* extension) {
  if (rig.size() == 1 && out.has_extension()) {
    return out;
  }
  std::string name =
      rig[camera].name.empty() ? fmt::format("camera-{}", camera + 1) : rig[camera].name;
  std::ranges::replace(name, '/', '_');
  return out / (name + extension);
}

} // namespace dewpoint::calibration
