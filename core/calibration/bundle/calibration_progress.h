// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <functional>
#include <string>

namespace dewpoint::calibration {

/// Told now and then how far a computation is: what it does, and the part done, 0 to 1. It goes on
/// while true is returned; after false it ends with cancelled(). May be empty.
using CalibrationProgress = std::function<bool(const std::string& stage, double part)>;

inline bool goesOn(const CalibrationProgress& progress, const std::string& stage, double part) {
  return !progress || progress(stage, part);
}

/// What a computation returns that was told to stop: Cancelled.
inline tl::unexpected<Error> cancelled() {
  return failure(ErrorCode::Cancelled, "", "", "");
}

} // namespace dewpoint::calibration
