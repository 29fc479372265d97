// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/message/frame_message.h"

#include <memory>

namespace dewpoint::tests {

/// Two cameras, named so that a format has to quote, and a volume of 2 x 4 x 1.
inline broadcast::RigMessage exampleRig() {
  broadcast::RigMessage rig;
  rig.cameras = {{"left", {1.0, 2.0, 3.0}, {0.0, 0.0, -1.0}},
                 {"the \"right\", one", {-1.5, 0.0, 2.0}, {1.0, 0.0, 0.0}}};
  rig.volume = {{0.0, -2.0, 0.0}, {2.0, 2.0, 1.0}};
  return rig;
}

/// Frame 12, at 0.4 s: a target that both cameras see, and one that is lost.
inline broadcast::FrameMessage exampleFrame() {
  broadcast::FrameMessage frame;
  frame.frame = 12;
  frame.sequenceNumber = 7;
  frame.time = 0.4;
  frame.rig = std::make_shared<const broadcast::RigMessage>(exampleRig());
  broadcast::TargetMessage& seen = frame.targets.emplace_back();
  seen.id = 1;
  seen.name = "pink ball";
  seen.state = "held";
  seen.position = {0.5, 1.0, 0.25};
  seen.covariance << 4e-6, 1e-6, 0.0, 1e-6, 9e-6, 2e-6, 0.0, 2e-6, 1e-6;
  seen.velocity = {1.0, 0.0, -0.5};
  seen.acceleration = {0.5, 0.0, 0.0};
  seen.existenceProbability = 0.75;
  seen.seeingCameras = {0, 1};
  broadcast::TargetMessage& lost = frame.targets.emplace_back();
  lost.id = 2;
  lost.name = "blue";
  lost.state = "lost";
  lost.existenceProbability = 0.125;
  return frame;
}

} // namespace dewpoint::tests
