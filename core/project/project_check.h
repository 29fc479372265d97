// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"

namespace dewpoint::project {

/// Checks that a project can be run: names are present and unique, color ranges and radii are
/// usable, and image sizes are positive. Errors name the field by its key in the project file.
Status checkProject(const Project& project);

/// Checks that a project defines the targets its method needs. If not, returns MissingKey, which
/// names the key "target" and describes what is missing.
Status checkMethodTargets(const Project& project);

} // namespace dewpoint::project
