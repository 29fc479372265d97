// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/recorded_camera.h"
#include "core/project/project.h"

namespace dewpoint::setup {

/// Returns the recording to open for a camera whose source is a video or an image folder. The image
/// size is the one in its calibration.
RecordedCamera recordedCamera(const ProjectCamera& camera);

} // namespace dewpoint::setup
