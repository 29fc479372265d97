// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/python/python_error.h"
#include "core/calibration/formats/calibration_adaptation.h"

#include <optional>
#include <string>

namespace dewpoint::app {

/// Returns the value of the Python argument `fit`, which has the same values as the command-line
/// option --fit; nothing if the argument is missing. Raises dewpoint.Error for any other text.
inline std::optional<SizeFit> sizeFitFromName(const std::optional<std::string>& fit) {
  if (!fit) {
    return std::nullopt;
  }
  const auto known = parseSizeFit(*fit);
  if (!known) {
    raiseBadValue("fit", "one of crop, rotate-270, rotate-90, scale, trim; not " + *fit);
  }
  return known;
}

} // namespace dewpoint::app
