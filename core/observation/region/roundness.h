// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/ellipsoid_image.h"
#include "core/observation/region/color_region.h"

#include <optional>

namespace dewpoint::observation {

/// Difference between the image of a target and the image of a ball.
struct Roundness {
  double elongation = 0.0; ///< log ratio of the axes of the pixel covariance, at least 0
  /// Area by which the region falls short of the ellipse with the same pixel covariance, as a share
  /// of that ellipse: 0 for any ellipse, 0.05 for a square, 0.17 for a triangle.
  double hollowness = 0.0;
  /// Logarithm of the factor (square root of the areas) by which the region is larger than the
  /// outlines of two such balls that touch. 0 if it is not larger: the ball is then all there is of
  /// its color.
  double excess = 0.0;
};

/// Roundness of a region relative to the outline of a ball at its position. At the edge of a wide
/// image this outline is an ellipse.
Roundness roundnessOf(const ColorRegion& region, const EllipseImage& ball);

/// Log likelihood ratio of a region under "any shape" against "a ball"; nothing if the region is
/// too small. If much of the rim ends at the image border or beside something that may hide the
/// target, only an excess in size counts as evidence.
std::optional<double> shapeEvidence(const ColorRegion& region, const EllipseImage& ball);

} // namespace dewpoint::observation
