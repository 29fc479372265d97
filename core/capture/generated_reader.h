// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_reader.h"
#include "core/capture/recorded_camera.h"

#include <string>

namespace dewpoint::capture {

/// Opens a reader for the images created by RecordedCamera::generate. `field` names the camera in
/// errors. Error: BadValue if the camera has no such function.
Result<FrameReaderPtr> openGeneratedReader(const RecordedCamera& camera, const std::string& field);

} // namespace dewpoint::capture
