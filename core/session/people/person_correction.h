// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"
#include "core/tracking/tracker_capabilities.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::session {

/// Somebody is there whom a method for people has not found by itself, or nobody is.
struct PeopleChange {
  std::optional<Eigen::Vector3d> newPerson; ///< PersonPlacing::addPerson
  std::optional<int> personGone;            ///< PersonPlacing::removePerson
};

/// The effect of a correction in its frame: a new person, or one to remove. What cannot be granted,
/// as somebody outside the watched floor, changes nothing and adds to `refusals`.
PeopleChange peopleChange(const PersonCorrection& correction, const PeopleFinding& finding,
                          const CameraRig& rig, const ParameterValues& parameters,
                          std::vector<Error>& refusals);

} // namespace dewpoint::session
