// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/geometry/camera.h"

#include <vector>

namespace dewpoint::camera_motion {

/// Returns the faults of a rig that are evident without any images. CameraFault::Unit: the cameras
/// are so far apart that their positions must be in a wrong unit. CameraFault::SamePose: two
/// cameras have the same pose.
std::vector<CameraDisagreement> checkRig(const CameraRig& rig);

/// Returns the likely length unit of a calibration, in meters: 0.001 for millimeters, 0.01 for
/// centimeters, 0.0254 for inches. `ratio` is the factor by which the lengths in the calibration
/// are too large if they are taken as meters. Returns 0 if `ratio` does not suit any of these
/// units.
double lengthUnitFromRatio(double ratio);

} // namespace dewpoint::camera_motion
