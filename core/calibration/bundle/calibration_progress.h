// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <functional>

namespace dewpoint::calibration {

/// Stage of a calibration.
enum class CalibrationStage {
  BoardDetection,  ///< searches for the board in images
  Intrinsics,      ///< estimates the intrinsics of one camera
  Chaining,        ///< finds initial poses along chains of cameras that saw the board together
  Adjustment,      ///< bundle adjustment of all cameras
  Assessment,      ///< estimates how accurate the result is
  PlacementSearch, ///< tries poses for an additional camera
};

/// Callback for the progress of a computation: the current stage and the completed fraction of it,
/// 0 to 1. If it returns false, the computation ends with the error canceledError(). The callback
/// may be empty.
using CalibrationProgress = std::function<bool(CalibrationStage stage, double part)>;

/// Reports the completed fraction `part` (0 to 1) of a stage to `progress`, unless `progress` is
/// empty. Returns false if the computation must stop.
inline bool reportProgress(const CalibrationProgress& progress, CalibrationStage stage,
                           double part) {
  return !progress || progress(stage, part);
}

/// Returns the error for a computation that was stopped: Canceled.
inline tl::unexpected<Error> canceledError() {
  return failure(ErrorCode::Canceled, "", "", "");
}

} // namespace dewpoint::calibration
