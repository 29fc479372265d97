// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/ellipsoid_image.h"
#include "core/observation/region/color_region.h"

#include <optional>

namespace dewpoint::observation {

/// Difference between the image of a target and the image of a ball.
struct Roundness {
  double elongation = 0.0; ///< log ratio of the axes of the pixel covariance, at least 0
  /// Area by which the region is smaller than the ellipse with the same pixel covariance, as a
  /// fraction of that ellipse. It is 0 for any ellipse, 0.05 for a square and 0.17 for a triangle.
  double hollowness = 0.0;
  /// Logarithm of the factor (square root of the area ratio) by which the region is larger than the
  /// outlines of two such balls that touch. 0 if it is not larger; the ball then accounts for all
  /// of its color.
  double excess = 0.0;
};

/// Returns the roundness of a region relative to the outline of a ball at its position. At the edge
/// of a wide-angle image, this outline is an ellipse.
Roundness roundnessOf(const ColorRegion& region, const EllipseImage& ball);

/// Returns the log likelihood ratio of a region under "any shape" against "a ball", or nothing if
/// the region is too small. If much of the rim is at the image border or next to something that may
/// hide the target, only excess size counts as evidence.
std::optional<double> shapeEvidence(const ColorRegion& region, const EllipseImage& ball);

} // namespace dewpoint::observation
