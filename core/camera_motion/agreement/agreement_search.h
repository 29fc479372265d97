// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/agreement_model.h"
#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/geometry/camera.h"

#include <optional>
#include <vector>

namespace dewpoint::camera_motion {

/// Returns whether the rig, as declared by its calibration, explains the sightings well, with
/// errors that are usual for calibrations.
bool isGoodFit(const AgreementFit& asDeclared);
/// Returns whether the rig as declared explains hardly any of the sightings.
bool isBadFit(const AgreementFit& asDeclared);

/// Returns the fault that explains the sightings clearly better than the rig as declared, and
/// clearly better than every other fault. Its log odds must be at least kLeastLogOdds against the
/// rig as declared, and at least kLeastLead against every other fault. If no fault meets this and
/// `alsoUnknown` is set, CameraFault::Unknown is returned if its log odds are at least
/// kLeastLogOdds. Otherwise returns nothing.
std::optional<CameraDisagreement> findFault(const AgreementModel& model, const CameraRig& rig,
                                            const AgreementFit& asDeclared, bool alsoUnknown);

/// Minimum log odds (natural logarithm) of a fault against no fault. At this limit, one report in
/// twenty is wrong.
inline constexpr double kLeastLogOdds = 3.0;
/// Minimum log odds (natural logarithm) of a fault against any other fault. At this limit, one
/// report in twenty names the wrong fault.
inline constexpr double kLeastLead = 3.0;

} // namespace dewpoint::camera_motion
