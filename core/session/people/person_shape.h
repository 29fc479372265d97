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
  /// Level curves of the person's density on the floor. Each entry has the curves around the
  /// smallest area in which the person stands with one of the probabilities kGroundProbabilities,
  /// the smallest area first. An area may have several parts.
  std::vector<std::vector<LevelCurve>> groundCurves;
};

/// Probabilities of the floor areas around which level curves are drawn: the person stands inside
/// an area with this probability.
inline constexpr double kGroundProbabilities[] = {0.25, 0.5, 0.75, 0.95};
/// Largest number of points from which a person's shape is computed, to limit the computing time.
inline constexpr int kMaxShapePoints = 500;

/// Returns the shape of a person's body, computed from an even selection of at most kMaxShapePoints
/// of its points.
PersonShape personShape(const BodyCloud& body);

} // namespace dewpoint::session
