// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/ellipsoid_image.h"
#include "core/observation/region/color_region.h"

#include <Eigen/Core>

#include <optional>

namespace dewpoint::observation {

/// What one image shows where the outline of a target of any shape is expected. Pixels.
struct RegionMeasurement {
  bool inView = false;               ///< there is an image, and the outline's center lies in it
  EllipseImage expected;             ///< the outline
  std::optional<ColorRegion> region; ///< what is taken for the target; nothing: not seen
  /// Share of the expected outline's area, 0 to 1, in which the target's color could be seen: not
  /// outside the image, and nothing there that may hide it.
  double visible = 0.0;
  double matched = 0.0; ///< share of that part that has the color
  double ring = 0.0;    ///< share of a ring around the outline that has the color
  /// From the centroid of that part to the outline's center.
  Eigen::Vector2d centerFromVisible = Eigen::Vector2d::Zero();

  /// Where the outline's center is by the region: its centroid, if what is hidden and outside the
  /// image is as expected. There must be a region.
  Eigen::Vector2d center() const { return region->centroid + centerFromVisible; }
  /// Share of the target that the region lacks, 0 to 1: of what is hidden or outside the image.
  double missing() const { return 1.0 - visible; }
};

/// Measures the image of a target around its expected outline, whose center is uncertain by
/// `centerCovariance` (px²). All pieces of the color that overlap with it belong to the target, as
/// far as they go. Makes the labels that are needed.
RegionMeasurement measureRegion(LabelImage& labels, const EllipseImage& expected,
                                const Eigen::Matrix2d& centerCovariance);

/// The evidence of one image for a target of any shape, as a log likelihood ratio against "not
/// there": its color inside the expected outline, of which it fills the share `fill` when it is
/// seen, against its color in a ring around. At most SphereEvidence's: what an image shows is worth
/// as much of a ball as of anything else.
double regionEvidence(const RegionMeasurement& measurement, double fill);
/// The evidence of an image that shows all of the target.
double fullRegionEvidence();

} // namespace dewpoint::observation
