// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/geometry/camera.h"

#include <vector>

namespace dewpoint::camera_motion {

/// Checks a rig before any images are available, and returns the faults found. CameraFault::Unit:
/// the cameras are so far apart that their positions must be in a wrong unit.
/// CameraFault::SamePose: two cameras have the same pose.
std::vector<CameraDisagreement> checkRig(const CameraRig& rig);

/// Returns the likely unit of a calibration, in meters: a millimeter, a centimeter or an inch.
/// `ratio` is the factor by which the lengths of the calibration, taken as meters, are too large.
/// Returns 0 if `ratio` is close to none of these units.
double unitFromRatio(double ratio);

} // namespace dewpoint::camera_motion
