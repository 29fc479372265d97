// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/session/session.h"
#include "core/simulation/people/office.h"

namespace dewpoint::app {

/// The project of the built-in scene of people (officeDay()).
Project projectOfOffice();
/// A source that renders the office, with the true positions of its people.
Result<SessionInputs> openOffice(Project project);
/// Where everybody truly is: middles of bodies, and whether they are inside the walls.
Trajectory truthOfOffice(const OfficeRenderer& renderer);

} // namespace dewpoint::app
