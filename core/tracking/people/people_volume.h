// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/convex_hull.h"
#include "core/geometry/level_curves.h"
#include "core/tracking/people_state.h"

namespace dewpoint::tracking {

/// P_H of Mohedano et al. 2009: the fraction of the occupancy density inside a person's volume.
inline constexpr double kVolumeProbability = 0.95;
/// Standard deviation of the Gaussian kernel of every particle, in meters; the paper does not give
/// one.
inline constexpr double kBodyKernel = 0.06;

/// Returns the occupancy density of a person (Mohedano et al. 2009, section 3) at the points of the
/// body, per m³: a Gaussian with standard deviation `sigma` (meters) at every point.
Eigen::ArrayXd densityAtPoints(const BodyCloud& body, double sigma = kBodyKernel);

/// Returns the smallest volume that contains `probability` of a person, as the convex hull of the
/// points of highest density (Mohedano et al. 2009, section 2, equation 2). Empty for an empty
/// body.
ConvexHull bodyHull(const BodyCloud& body, double probability = kVolumeProbability,
                    double sigma = kBodyKernel);

/// Returns the occupancy density projected on the ground, per m², on a grid that extends three
/// sigmas beyond the points.
GroundGrid groundDensity(const BodyCloud& body, double step = 0.05, double sigma = kBodyKernel);

} // namespace dewpoint::tracking
