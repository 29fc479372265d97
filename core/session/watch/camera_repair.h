// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/project/project.h"

#include <cstddef>

namespace dewpoint::session {

/// Returns the number of ways to correct a fault by changing the project: pairs of cameras to
/// exchange, or cameras to rotate. 0 if only a new calibration can correct it.
std::size_t repairChoiceCount(const CameraDisagreement& found);

/// Corrects a fault found with the project's cameras in one of these ways (`choice` is asserted).
/// For exchanged cameras, exchanges their images with all clicks made in them. In a simulated
/// scene, images cannot be exchanged, so the calibrations are exchanged instead. A rotated camera
/// gets the rotation that was found, a delayed camera gets its delay, and the positions of a rig in
/// another unit are converted to meters.
void repairCameras(Project& project, const CameraDisagreement& found, std::size_t choice);

} // namespace dewpoint::session
