// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/picture_reader.h"
#include "core/capture/recorded_camera.h"

#include <string>

namespace dewpoint::capture {

/// The pictures that RecordedCamera::generate makes. `field` names the camera in errors: BadValue
/// when nothing makes any.
Result<PictureReaderPtr> openGeneratedReader(const RecordedCamera& camera,
                                             const std::string& field);

} // namespace dewpoint::capture
