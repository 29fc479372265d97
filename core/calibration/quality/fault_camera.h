// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/fault.h"
#include "core/calibration/quality/fault_search_input.h"

#include <cstddef>
#include <optional>

namespace dewpoint::calibration {

/// Camera that was left out of a fit because it may have a fault, and the points as seen by the
/// other cameras.
struct SuspectCamera {
  std::size_t camera = 0;
  const ImagePoints* imagePoints = nullptr;
  const PointPositions* positions = nullptr; ///< points triangulated by the other cameras
  /// Standard deviation of the image points in the fit of the other cameras, pixels.
  double sigmaPx = 1.0;
};

/// Finds the fault that best explains the images of a camera that may have one. Returns nothing if
/// no fault explains them clearly better than assuming no fault.
std::optional<DetectedFault> findCameraFault(const FaultSearchInput& input,
                                             const SuspectCamera& suspect);

} // namespace dewpoint::calibration
