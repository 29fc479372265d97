// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/fault.h"
#include "core/calibration/quality/fault_question.h"

#include <cstddef>
#include <optional>

namespace dewpoint::calibration {

/// A camera that is left out of the fit, and the points as the other cameras see them.
struct Suspect {
  std::size_t camera = 0;
  const ImagePoints* imagePoints = nullptr;
  const PointPositions* positions = nullptr; ///< triangulated by the other cameras
  double sigmaPx = 1.0; ///< standard deviation of the image points that the other cameras explain
};

/// Finds the fault that explains a suspect best, if it explains it clearly better than no fault.
std::optional<NamedFault> faultOfCamera(const FaultQuestion& question, const Suspect& suspect);

} // namespace dewpoint::calibration
