// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/convex_hull.h"
#include "core/geometry/level_curves.h"
#include "core/tracking/people_state.h"

#include <vector>

namespace dewpoint::session {

/// Shape of a person's body for display (Mohedano et al. 2009, figures 1 and 2). World frame,
/// meters.
struct PersonShape {
  ConvexHull hull;     ///< convex hull of the 95 % volume
  double volume = 0.0; ///< volume of the hull, m³
  /// Level curves around the smallest areas of the floor that contain the fractions
  /// kGroundFractions of the density, the smallest area first. Each area may have several parts.
  std::vector<std::vector<LevelCurve>> ground;
};

/// Fractions of the density on the floor for the level curves.
inline constexpr double kGroundFractions[] = {0.25, 0.5, 0.75, 0.95};
/// Largest number of points used for a person's shape, since the density is a sum over all pairs.
inline constexpr int kMaxShapePoints = 500;

/// Returns the shape of a body from an even selection of up to kMaxShapePoints of its points.
PersonShape personShape(const BodyCloud& body);

} // namespace dewpoint::session
