// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/people/posture.h"

#include <algorithm>

namespace dewpoint::simulation {
namespace {

/// Radians; chosen so that a sitting person's seat is about as high as the knees.
constexpr JointAngles kSitting{0.05F, 1.5F, 0.0F, 0.35F, 0.6F};
/// Radians; chosen: the hips 0.2 m above the floor, the heels below them.
constexpr JointAngles kCrouching{0.5F, 1.9F, -0.75F, 0.5F, 0.4F};

float mixed(float from, float to, float share) {
  return (1.0F - share) * from + share * to;
}

} // namespace

JointAngles jointAnglesOf(Posture posture) {
  switch (posture) {
  case Posture::Sitting:
    return kSitting;
  case Posture::Crouching:
    return kCrouching;
  case Posture::Standing:
    break;
  }
  return {};
}

JointAngles jointAnglesAt(const std::vector<PostureChange>& changes, double time) {
  JointAngles now;
  for (const PostureChange& change : changes) {
    if (time <= change.time) {
      break;
    }
    const auto part = static_cast<float>(std::min(1.0, (time - change.time) / kPostureSeconds));
    const float share = part * part * (3.0F - 2.0F * part);
    const JointAngles next = jointAnglesOf(change.posture);
    now = {mixed(now.lean, next.lean, share), mixed(now.thigh, next.thigh, share),
           mixed(now.shin, next.shin, share), mixed(now.arm, next.arm, share),
           mixed(now.forearm, next.forearm, share)};
  }
  return now;
}

} // namespace dewpoint::simulation
