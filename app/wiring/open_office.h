// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/session/session.h"
#include "core/simulation/people/office.h"

namespace dewpoint::app {

/// Returns the project of the built-in scene with people (`builtInOfficeScene()`).
Project makeOfficeProject();
/// Returns the inputs for a session that tracks the simulated office: a source that renders its
/// images, and the true positions of its people.
Result<SessionInputs> openOfficeInputs(Project project);
/// Returns the true positions of all people in the simulated office: the centers of their bodies
/// (meters), and whether they are inside the walls.
Trajectory officeGroundTruth(const OfficeRenderer& renderer);

} // namespace dewpoint::app
