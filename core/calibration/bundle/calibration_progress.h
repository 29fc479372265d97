// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <functional>

namespace dewpoint::calibration {

/// The stage of a calibration.
enum class CalibrationStage {
  BoardDetection,  ///< searches for the board in images
  Intrinsics,      ///< solves for the intrinsics of one camera
  Chaining,        ///< finds initial poses along chains of cameras that saw the board together
  Adjustment,      ///< bundle adjustment of all cameras
  Assessment,      ///< estimates how accurate the result is
  PlacementSearch, ///< tries poses for an additional camera
};

/// Callback that reports the stage of a computation and the share of it that is done, 0 to 1. The
/// computation continues while the callback returns true; after false it ends with cancelled(). May
/// be empty.
using CalibrationProgress = std::function<bool(CalibrationStage stage, double part)>;

/// Reports progress; returns false if the computation must stop.
inline bool goesOn(const CalibrationProgress& progress, CalibrationStage stage, double part) {
  return !progress || progress(stage, part);
}

/// Error of a computation that was stopped: Cancelled.
inline tl::unexpected<Error> cancelled() {
  return failure(ErrorCode::Cancelled, "", "", "");
}

} // namespace dewpoint::calibration
