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

/// Told now and then how far a computation is: what it does, and the part of that done, 0 to 1. It
/// goes on while true is returned; after false it ends with canceled(). May be empty.
using CalibrationProgress = std::function<bool(CalibrationStage stage, double part)>;

/// Reports progress; returns false if the computation must stop.
inline bool goesOn(const CalibrationProgress& progress, CalibrationStage stage, double part) {
  return !progress || progress(stage, part);
}

/// The error of a computation that was stopped: Canceled.
inline tl::unexpected<Error> canceled() {
  return failure(ErrorCode::Canceled, "", "", "");
}

} // namespace dewpoint::calibration
