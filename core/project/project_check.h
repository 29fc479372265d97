// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"

namespace dewpoint::project {

/// Whether a run can be made of it: names that are there and differ, usable color ranges and radii,
/// positive image sizes. The error names the field as the project file does.
Status checkProject(const Project& project);

/// Whether a project names what its method is to follow; MissingKey names "target" and says what is
/// missing.
Status checkMethodTargets(const Project& project);

} // namespace dewpoint::project
