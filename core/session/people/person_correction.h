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

/// The first frame for which other corrections hold; nothing when they are the same.
std::optional<std::int64_t> firstDifference(const std::vector<PersonCorrection>& before,
                                            const std::vector<PersonCorrection>& after);
/// What `after` adds to `before`, with which it begins; nothing when it does not.
std::optional<std::vector<PersonCorrection>> additions(const std::vector<PersonCorrection>& before,
                                                       const std::vector<PersonCorrection>& after);

} // namespace dewpoint::session
