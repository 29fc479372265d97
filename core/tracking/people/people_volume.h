// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/convex_hull.h"
#include "core/geometry/level_curves.h"
#include "core/tracking/people_state.h"

namespace dewpoint::tracking {

/// Fraction of the occupancy density that lies inside a person's volume: P_H of Mohedano et al.
/// 2009.
inline constexpr double kVolumeProbability = 0.95;
/// Standard deviation, in meters, of the Gaussian kernel around every particle of a person.
/// Mohedano et al. 2009 do not give a value.
inline constexpr double kBodyKernel = 0.06;

/// Returns the occupancy density of a person (Mohedano et al. 2009, section 3) at the points of the
/// body, per m³: a Gaussian with standard deviation `sigma` (meters) at every point.
Eigen::ArrayXd densityAtPoints(const BodyCloud& body, double sigma = kBodyKernel);

/// Returns the smallest volume that contains the fraction `probability` of a person's occupancy
/// density: the convex hull of the points of highest density (Mohedano et al. 2009, section 2,
/// equation 2). `sigma` (meters) is the standard deviation of the Gaussian at every point of the
/// body. Returns an empty hull for an empty body.
ConvexHull bodyHull(const BodyCloud& body, double probability = kVolumeProbability,
                    double sigma = kBodyKernel);

/// Returns the occupancy density of a person projected onto the ground, per m². `sigma` (meters) is
/// the standard deviation of the Gaussian at every point of the body. The grid has a spacing of
/// `step` meters and extends three standard deviations beyond the points.
GroundGrid groundDensity(const BodyCloud& body, double step = 0.05, double sigma = kBodyKernel);

} // namespace dewpoint::tracking
