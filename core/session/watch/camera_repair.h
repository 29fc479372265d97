// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/project/project.h"

#include <cstddef>

namespace dewpoint::session {

/// Returns the number of alternative changes to the project that may correct a fault, for example
/// one per pair of cameras to exchange or per camera to rotate. 0 if only a new calibration can
/// correct it.
std::size_t repairChoiceCount(const CameraDisagreement& found);

/// Applies alternative number `choice` (asserted to be less than repairChoiceCount()) to correct a
/// fault of the project's cameras. For exchanged cameras, exchanges their images with all clicks
/// made in them. In a simulated scene, images cannot be exchanged, so the calibrations are
/// exchanged instead. A rotated camera gets the rotation that was found, a delayed camera gets its
/// delay, and the positions of a rig in another unit are converted to meters.
void repairCameras(Project& project, const CameraDisagreement& found, std::size_t choice);

} // namespace dewpoint::session
