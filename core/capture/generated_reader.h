// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/picture_reader.h"
#include "core/capture/recorded_camera.h"

#include <string>

namespace dewpoint::capture {

/// Reader for the images that RecordedCamera::generate makes. `field` names the camera in errors:
/// BadValue when the camera has no such function.
Result<PictureReaderPtr> openGeneratedReader(const RecordedCamera& camera,
                                             const std::string& field);

} // namespace dewpoint::capture
