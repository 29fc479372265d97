// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/body/moving_part.h"
#include "core/simulation/people/walker.h"

#include <vector>

namespace dewpoint::simulation {

// Everyday objects that are no balls, around the origin of axes of their own: X forward, Z up;
// meters. What has `color` (BGR in full light) is marked as target; the rest is what carries it.

/// A peaked cap on a head with a neck; the origin is in the crown.
std::vector<MovingPart> capOnHead(const Vector3f& color);

/// A hand in a glove, open (0) to closed (1), on a bare forearm; the origin is in the palm.
std::vector<MovingPart> glovedHand(double closed, const Vector3f& color);

/// The sleeve of a forearm, 24 cm long, with a bare hand.
std::vector<MovingPart> sleevedArm(const Vector3f& color);

/// A cone 18 cm high and 12 cm wide.
std::vector<MovingPart> cone(const Vector3f& color);

/// A stick 30 cm long and 16 mm thick, along X.
std::vector<MovingPart> stick(const Vector3f& color);

/// A computer mouse, 12 x 6.4 cm and 4 cm high.
std::vector<MovingPart> computerMouse(const Vector3f& color);

/// A walking person's parts in the world; those in the color of the shirt are marked as target.
std::vector<MovingPart> shirtOnPerson(const Walker& walker, double time);

} // namespace dewpoint::simulation
