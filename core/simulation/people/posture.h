// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <vector>

namespace dewpoint::simulation {

/// Posture of a body.
enum class Posture { Standing, Sitting, Crouching };

/// Time in seconds for sitting down, crouching or rising; chosen: unhurried.
inline constexpr double kPostureSeconds = 1.0;

/// Beginning of a change of posture, in seconds; it is complete kPostureSeconds later.
struct PostureChange {
  double time = 0.0;
  Posture posture = Posture::Standing;
};

/// Angles of the joints of a body, radians, positive forward; all 0 for a standing person.
struct JointAngles {
  float lean = 0.0F;    ///< of the trunk about the hips, from upright
  float thigh = 0.0F;   ///< of both thighs, from hanging
  float shin = 0.0F;    ///< of both shins, from hanging
  float arm = 0.0F;     ///< of both upper arms, from hanging
  float forearm = 0.0F; ///< of both forearms, relative to the upper arms

  bool upright() const { return lean == 0.0F && thigh == 0.0F && shin == 0.0F; }
};

/// Returns the angles of a posture.
JointAngles anglesOf(Posture posture);

/// Returns the angles at `time` of a person who stands before the first of `changes`, which are in
/// order of time. They are smooth during a change, and exactly those of the posture after it.
JointAngles anglesAt(const std::vector<PostureChange>& changes, double time);

} // namespace dewpoint::simulation
