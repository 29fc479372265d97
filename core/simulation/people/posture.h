// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <vector>

namespace dewpoint::simulation {

/// Posture of a body.
enum class Posture { Standing, Sitting, Crouching };

/// Duration of sitting down, crouching or rising, in seconds. Chosen to look unhurried.
inline constexpr double kPostureSeconds = 1.0;

/// Change to a new posture, which starts at `time` (seconds) and takes kPostureSeconds.
struct PostureChange {
  double time = 0.0;
  Posture posture = Posture::Standing;
};

/// Joint angles of a body in radians, positive forward. All angles are 0 for a standing person.
struct JointAngles {
  float lean = 0.0F;    ///< angle of the trunk about the hips, measured from upright
  float thigh = 0.0F;   ///< angle of both thighs, measured from hanging straight down
  float shin = 0.0F;    ///< angle of both shins, measured from hanging straight down
  float arm = 0.0F;     ///< angle of both upper arms, measured from hanging straight down
  float forearm = 0.0F; ///< angle of both forearms, relative to the upper arms

  bool isUpright() const { return lean == 0.0F && thigh == 0.0F && shin == 0.0F; }
};

/// Returns the joint angles of a posture.
JointAngles jointAnglesOf(Posture posture);

/// Returns the joint angles of a person at `time` (seconds). The person stands before the first of
/// `changes`, which must be in order of time. The angles vary smoothly during a change. After the
/// change, they are the angles of the new posture.
JointAngles jointAnglesAt(const std::vector<PostureChange>& changes, double time);

} // namespace dewpoint::simulation
