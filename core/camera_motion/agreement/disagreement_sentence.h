// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/geometry/camera.h"

#include <string>

namespace dewpoint::camera_motion {

/// Describes a fault and its correction in plain English for the command line: "left and right seem
/// to be swapped; exchange their images in the project file". Without a period at the end.
std::string disagreementSentence(const CameraDisagreement& found, const CameraRig& rig);

} // namespace dewpoint::camera_motion
