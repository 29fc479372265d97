// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/convex_hull.h"
#include "core/geometry/level_curves.h"
#include "core/tracking/people_state.h"

#include <vector>

namespace dewpoint::session {

/// What views show of a person's body (Mohedano et al. 2009, figures 1 and 2). Meters, world.
struct PersonShape {
  ConvexHull hull;     ///< of the 95 % volume
  double volume = 0.0; ///< m³, of the hull
  /// Around the smallest areas of the floor that hold kGroundShares of the density, the smallest
  /// first; each may have several pieces.
  std::vector<std::vector<LevelCurve>> ground;
};

/// Shares of the density on the floor that level curves are drawn around.
inline constexpr double kGroundShares[] = {0.25, 0.5, 0.75, 0.95};
/// Points of a body that its shape is made of, at most: the density is a sum over all pairs.
inline constexpr int kShapePoints = 500;

/// The shape of a body, of up to kShapePoints of its points, evenly picked.
PersonShape personShape(const BodyCloud& body);

} // namespace dewpoint::session
