// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

namespace dewpoint::project {

/// Returns the cameras of a project, in project order.
CameraRig rigOf(const Project& project);

/// Returns whether both rigs have the same number of cameras with the same image sizes. One rig can
/// then replace the other without changing the image sources.
bool haveSameImageSizes(const CameraRig& a, const CameraRig& b);

} // namespace dewpoint::project
