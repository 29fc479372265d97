// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/recorded_camera.h"
#include "core/project/project.h"

namespace dewpoint::setup {

/// What is opened for a camera of a project that is a video or a folder of images, at the size that
/// its calibration says.
RecordedCamera recordedCamera(const ProjectCamera& camera);

} // namespace dewpoint::setup
