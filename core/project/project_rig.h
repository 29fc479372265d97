// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

namespace dewpoint::project {

/// The cameras of a project, in its order.
CameraRig rigOf(const Project& project);

/// Whether both rigs have the same number of cameras with the same image sizes: then one can
/// replace the other while the same images come in.
bool haveSameImages(const CameraRig& a, const CameraRig& b);

} // namespace dewpoint::project
