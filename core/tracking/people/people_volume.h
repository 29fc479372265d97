// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/convex_hull.h"
#include "core/geometry/level_curves.h"
#include "core/tracking/people_state.h"

namespace dewpoint::tracking {

/// P_H of Mohedano et al. 2009: the share of the occupancy density that a person's volume holds.
inline constexpr double kVolumeProbability = 0.95;
/// Standard deviation of the Gaussian kernel on every particle, meters; the paper gives none.
inline constexpr double kBodyKernel = 0.06;

/// The occupancy density of a person (Mohedano et al. 2009, section 3): a Gaussian of `sigma`
/// meters on every point of the body; per m³, at the points themselves.
Eigen::ArrayXd densityAtPoints(const BodyCloud& body, double sigma = kBodyKernel);

/// The smallest volume that holds `probability` of a person, as the convex hull of the points of
/// highest density (section 2, equation 2). Empty for an empty body.
ConvexHull bodyHull(const BodyCloud& body, double probability = kVolumeProbability,
                    double sigma = kBodyKernel);

/// The occupancy density projected on the ground, per m², on a grid that reaches three sigmas
/// beyond the points.
GroundGrid groundDensity(const BodyCloud& body, double step = 0.05, double sigma = kBodyKernel);

} // namespace dewpoint::tracking
