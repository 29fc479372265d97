// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/geometry/camera.h"

#include <string>

namespace dewpoint::camera_motion {

/// Returns a plain English description of a fault and its correction for the command line, for
/// example "left and right seem to be swapped; exchange their images in the project file". The text
/// does not end with a period.
std::string describeDisagreement(const CameraDisagreement& found, const CameraRig& rig);

} // namespace dewpoint::camera_motion
