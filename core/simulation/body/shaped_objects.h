// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/body/moving_part.h"
#include "core/simulation/people/walker.h"

#include <vector>

namespace dewpoint::simulation {

// Everyday objects that are not balls. Each object lies around the origin of its own axes (X
// forward, Z up, meters). Parts with `color` (BGR in full light) are marked as target. Other parts,
// such as a head or a hand, wear or hold the target.

/// Returns a peaked cap of this color (BGR) on a head with a neck. The origin is inside the crown
/// of the cap.
std::vector<MovingPart> capOnHead(const Vector3f& color);

/// Returns a hand in a glove of this color (BGR) on a bare forearm. `closed` ranges from 0 (open)
/// to 1 (closed). The origin is in the palm.
std::vector<MovingPart> glovedHand(double closed, const Vector3f& color);

/// Returns a forearm in a sleeve of this color (BGR), 24 cm long, with a bare hand.
std::vector<MovingPart> sleevedArm(const Vector3f& color);

/// Returns a cone 18 cm high and 12 cm wide.
std::vector<MovingPart> cone(const Vector3f& color);

/// Returns a stick 30 cm long and 16 mm thick, along X.
std::vector<MovingPart> stick(const Vector3f& color);

/// Returns a computer mouse, 12 x 6.4 cm and 4 cm high.
std::vector<MovingPart> computerMouse(const Vector3f& color);

/// Returns the parts of a walking person at `time` (seconds), in the world frame (meters). Parts
/// with the color of the shirt are marked as the target.
std::vector<MovingPart> shirtOnPerson(const Walker& walker, double time);

} // namespace dewpoint::simulation
