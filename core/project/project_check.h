// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"

namespace dewpoint::project {

/// Checks that a project can be run: names are present and unique, color ranges and radii are
/// usable, and image sizes are positive. The error names the field as the project file does.
Status checkProject(const Project& project);

/// Checks that a project names the targets its method needs. Otherwise returns MissingKey, which
/// names "target" and says what is missing.
Status checkMethodTargets(const Project& project);

} // namespace dewpoint::project
