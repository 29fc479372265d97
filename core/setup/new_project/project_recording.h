// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/recorded_camera.h"
#include "core/project/project.h"

namespace dewpoint::setup {

/// Returns the description with which openRecording() opens the recording of a camera. The source
/// of the camera must be a video or an image folder. The image size is taken from the calibration
/// of the camera.
RecordedCamera recordedCamera(const ProjectCamera& camera);

} // namespace dewpoint::setup
