// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/calibration_format.h"

#include "core/calibration/formats/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::calibration {

std::optional<double> parseLengthUnit(const std::string& text) {
  for (const auto& [name, meters] :
       {std::pair("m", 1.0), std::pair("mm", 0.001), std::pair("cm", 0.01), std::pair("in", 0.0254),
        std::pair("ft", 0.3048)}) {
    if (text == name) {
      return meters;
    }
  }
  const auto meters = parseNumber(text);
  return meters && *meters > 0.0 && std::isfinite(*meters) ? meters : std::nullopt;
}

std::string lengthUnitProblem(const std::string& text) {
  return parseLengthUnit(text) ? ""
                               : "expected m, mm, cm, in, ft, or the length of one unit in meters";
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
