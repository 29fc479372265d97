// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/agreement_model.h"
#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/geometry/camera.h"

#include <optional>
#include <vector>

namespace dewpoint::camera_motion {

/// Returns whether the rig as declared explains the sightings well, with errors that are usual for
/// calibrations.
bool isGoodFit(const AgreementFit& asDeclared);
/// Returns whether the rig as declared explains hardly any of the sightings.
bool isBadFit(const AgreementFit& asDeclared);

/// Finds a fault that explains the sightings clearly better than the declared rig (log odds of at
/// least kLeastLogOdds) and than every other fault (by at least kLeastLead). If several faults
/// remain, or none explains the sightings, there are two cases: with `alsoUnknown`, the result is
/// that the cameras disagree; otherwise, the result is nothing.
std::optional<CameraDisagreement> findFault(const AgreementModel& model, const CameraRig& rig,
                                            const AgreementFit& asDeclared, bool alsoUnknown);

/// Minimum log odds (natural logarithm) of a fault against no fault: one report in twenty is wrong.
inline constexpr double kLeastLogOdds = 3.0;
/// Minimum log odds (natural logarithm) of a fault against any other fault: one in twenty is wrong.
inline constexpr double kLeastLead = 3.0;

} // namespace dewpoint::camera_motion
