// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/project/project.h"

#include <cstddef>

namespace dewpoint::session {

/// In how many ways a change of the project mends a fault: which of two pairs is exchanged, which
/// of two cameras is rotated. 0: by a new calibration only.
std::size_t mendingChoices(const CameraDisagreement& found);

/// Mends a fault that was found with the project's cameras, in one of its ways (asserted).
/// Exchanged are the images of two cameras, with all clicks that were made in them; of a simulated
/// scene, whose images are made as they are, the calibrations. A rotated camera gets the rotation
/// that was found, a late one the delay, and the positions of a rig in another unit become meters.
void mendCameras(Project& project, const CameraDisagreement& found, std::size_t choice);

} // namespace dewpoint::session
