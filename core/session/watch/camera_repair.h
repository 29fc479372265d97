// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/project/project.h"

#include <cstddef>

namespace dewpoint::session {

/// Returns the number of alternative changes to the project that may correct a fault of the
/// cameras, for example one per pair of cameras to exchange or per camera to rotate. Returns 0 if
/// only a new calibration can correct the fault.
std::size_t repairChoiceCount(const CameraDisagreement& found);

/// Corrects a fault of the project's cameras by alternative number `choice`, which must be less
/// than repairChoiceCount(). For two exchanged cameras, exchanges their images and all clicks made
/// in them; in a simulated scene, exchanges the calibrations instead. A rotated camera gets the
/// rotation that was found, a delayed camera gets its delay, and the positions of a rig in another
/// unit are converted to meters.
void repairCameras(Project& project, const CameraDisagreement& found, std::size_t choice);

} // namespace dewpoint::session
