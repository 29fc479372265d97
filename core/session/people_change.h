// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/session/command.h"
#include "core/session/run/tracking_run.h"

#include <vector>

namespace dewpoint::session {

/// What a wish means to a run of a method for people: who is new, and who is gone. Wishes that
/// cannot be granted, as somebody outside the watched floor, are left out and add to `refusals`.
PeopleChange peopleChange(const TrackingRun& run, const command::ChangePeople& wish,
                          std::vector<Error>& refusals);

} // namespace dewpoint::session
