// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/camera_limit.h"

#include <fmt/format.h>

namespace dewpoint::calibration {

tl::unexpected<Error> tooManyCamerasError(const std::string& file) {
  return failure(ErrorCode::BadValue, file, fmt::format("camera {}", limits::kMaxCameras + 1),
                 fmt::format("at most {} cameras are possible", limits::kMaxCameras));
}

} // namespace dewpoint::calibration
