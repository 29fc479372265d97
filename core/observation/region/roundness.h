// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/ellipsoid_image.h"
#include "core/observation/region/color_region.h"

#include <optional>

namespace dewpoint::observation {

/// Differences between the color region of a target and the image of a ball.
struct Roundness {
  /// Logarithm of the ratio of the region's axes, relative to the outline of the ball; at least 0.
  double elongation = 0.0;
  /// Area by which the region is smaller than the ellipse with the same pixel covariance, as a
  /// fraction of the area of the ellipse. The value is 0 for any ellipse, 0.05 for a square and
  /// 0.17 for a triangle.
  double hollowness = 0.0;
  /// Logarithm of the factor by which the region is larger than the outlines of two touching balls
  /// of the expected size. The factor is the square root of the area ratio. The value is 0 if the
  /// region is not larger, because a ball that touches another object of its color and size then
  /// explains the whole region.
  double sizeExcess = 0.0;
};

/// Returns the roundness of a region relative to `ball`, the outline of a ball at the target's
/// position. At the edge of a wide-angle image, this outline is an ellipse.
Roundness roundnessOf(const ColorRegion& region, const EllipseImage& ball);

/// Returns the log likelihood ratio of "the target has any shape" against "the target is a ball"
/// for a region, or nothing if the region is too small. If much of the region's rim is at the image
/// border or next to an object that may hide the target, only the excess size is used as evidence.
std::optional<double> shapeEvidence(const ColorRegion& region, const EllipseImage& ball);

} // namespace dewpoint::observation
