// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/limits.h"

#include <string>

namespace dewpoint::calibration {

/// Returns the error for a file with more than limits::kMaxCameras cameras.
tl::unexpected<Error> tooManyCamerasError(const std::string& file);

} // namespace dewpoint::calibration
