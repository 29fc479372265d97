// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/agreement_model.h"
#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/geometry/camera.h"

#include <optional>
#include <vector>

namespace dewpoint::camera_motion {

/// Whether the rig as declared explains what the cameras saw: enough of it, and with errors that
/// calibrations usually have.
bool isGood(const AgreementFit& asDeclared);
/// Whether it explains hardly anything of it.
bool isBad(const AgreementFit& asDeclared);

/// The fault that explains what the cameras saw clearly better than that nothing is wrong: by
/// log odds of kLeastLogOdds, and of kLeastLead against every other one. Of those that leave open
/// which, and where none explains it, nothing, or with `alsoUnknown` that the cameras disagree.
std::optional<CameraDisagreement> findFault(const AgreementModel& model, const CameraRig& rig,
                                            const AgreementFit& asDeclared, bool alsoUnknown);

/// Of a fault against none, natural logarithms: one in twenty is wrong.
inline constexpr double kLeastLogOdds = 3.0;
/// Of a fault against another: one in twenty.
inline constexpr double kLeastLead = 3.0;

} // namespace dewpoint::camera_motion
