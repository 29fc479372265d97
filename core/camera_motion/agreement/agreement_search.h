// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/agreement_model.h"
#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/geometry/camera.h"

#include <optional>
#include <vector>

namespace dewpoint::camera_motion {

/// Returns whether the rig explains the sightings well as it is calibrated, with no errors larger
/// than usual. `asDeclared` is the fit of the hypothesis without a fault.
bool isGoodFit(const AgreementFit& asDeclared);
/// Returns whether the rig as it is calibrated explains hardly any of the sightings. `asDeclared`
/// is the fit of the hypothesis without a fault.
bool isBadFit(const AgreementFit& asDeclared);

/// Returns the fault that explains the sightings clearly better than no fault, and clearly better
/// than every other fault. The log odds of this fault must be at least kMinLogOdds against no
/// fault, and at least kMinLead against every other fault. `asDeclared` is the fit of the
/// hypothesis without a fault. If there is no such fault and `alsoUnknown` is set, returns
/// CameraFault::Unknown if its log odds are at least kMinLogOdds. Otherwise returns nothing.
std::optional<CameraDisagreement> findFault(const AgreementModel& model, const CameraRig& rig,
                                            const AgreementFit& asDeclared, bool alsoUnknown);

/// Minimum log odds (natural logarithm) of a fault against no fault. At this limit, one report in
/// twenty is wrong.
inline constexpr double kMinLogOdds = 3.0;
/// Minimum log odds (natural logarithm) of a fault against any other fault. At this limit, one
/// report in twenty names the wrong fault.
inline constexpr double kMinLead = 3.0;

} // namespace dewpoint::camera_motion
