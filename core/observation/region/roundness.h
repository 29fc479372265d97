// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/ellipsoid_image.h"
#include "core/observation/region/color_region.h"

#include <optional>

namespace dewpoint::observation {

/// How one image of a target compares with that of a ball.
struct Roundness {
  double elongation = 0.0; ///< logarithm of the ratio of the axes by the second moments, at least 0
  /// Area that the region lacks to fill the ellipse of its second moments, as a share of it: 0 of a
  /// disc and of any other ellipse, 0.05 of a square, 0.17 of a triangle.
  double hollowness = 0.0;
  /// Logarithm of the factor by which the region is larger than the outlines of two such balls that
  /// touch (square root of the areas), 0 where it is not: a ball is all that there is of its color.
  double excess = 0.0;
};

/// The roundness of a region relative to the outline of a ball at its place, which is an ellipse at
/// the edge of a wide image.
Roundness roundnessOf(const ColorRegion& region, const EllipseImage& ball);

/// Logarithm of the ratio of the likelihoods of a region under "anything" and under "a ball";
/// nothing when the region is too small. Where much of its rim ends at the image's border or beside
/// what may hide it, only that it is larger than the ball says something, and it does then.
std::optional<double> shapeEvidence(const ColorRegion& region, const EllipseImage& ball);

} // namespace dewpoint::observation
