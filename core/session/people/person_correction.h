// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"
#include "core/tracking/tracker_capabilities.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::session {

/// Change to the people that a method tracks: adds a person that it has not found, or removes one
/// that does not exist.
struct PeopleChange {
  /// Position of a person to add: the center of the body, meters, world frame.
  std::optional<Eigen::Vector3d> newPersonPosition;
  /// Identity of a person to remove.
  std::optional<int> removedPersonId;
};

/// Returns the effect of a user's correction in its frame: a person to add, or one to remove. A
/// correction that cannot be applied (for example, a person outside the observed floor) changes
/// nothing and adds an error to `correctionErrors`.
PeopleChange peopleChange(const PersonCorrection& correction, const PeopleFinding& finding,
                          const CameraRig& rig, const ParameterValues& parameters,
                          std::vector<Error>& correctionErrors);

} // namespace dewpoint::session
