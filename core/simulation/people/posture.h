// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <vector>

namespace dewpoint::simulation {

/// How a body is held.
enum class Posture { Standing, Sitting, Crouching };

/// Seconds in which somebody sits down, crouches or rises; chosen: unhurried.
inline constexpr double kPostureSeconds = 1.0;

/// From `time` on (seconds) a body takes another posture; it is reached kPostureSeconds later.
struct PostureChange {
  double time = 0.0;
  Posture posture = Posture::Standing;
};

/// Angles of the joints of a body, radians, positive forward; all 0 for somebody who stands.
struct JointAngles {
  float lean = 0.0F;    ///< of the trunk about the hips, from upright
  float thigh = 0.0F;   ///< of both thighs, from hanging
  float shin = 0.0F;    ///< of both shins, from hanging
  float arm = 0.0F;     ///< of both upper arms, from hanging
  float forearm = 0.0F; ///< of both forearms, further than the upper arms

  bool upright() const { return lean == 0.0F && thigh == 0.0F && shin == 0.0F; }
};

/// The angles of a posture.
JointAngles anglesOf(Posture posture);

/// The angles at `time`, of somebody who stands before the first of `changes`, which are in the
/// order of their times; smooth in between, and exactly those of the posture once it is reached.
JointAngles anglesAt(const std::vector<PostureChange>& changes, double time);

} // namespace dewpoint::simulation
