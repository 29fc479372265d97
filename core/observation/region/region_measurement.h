// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/ellipsoid_image.h"
#include "core/observation/region/color_region.h"

#include <Eigen/Core>

#include <optional>

namespace dewpoint::observation {

/// Measurement of a target of any shape in one image, near its expected outline. Pixels.
struct RegionMeasurement {
  bool inView = false;               ///< the camera has an image that contains the outline's center
  EllipseImage expected;             ///< expected outline
  std::optional<ColorRegion> region; ///< region assigned to the target; nothing if it is not seen
  /// Share of the expected outline's area, 0 to 1, in which the target's color could be seen:
  /// inside the image, and not behind something that may hide it.
  double visible = 0.0;
  double matched = 0.0; ///< share of that part that has the color, 0 to 1
  double ring = 0.0;    ///< share of a ring around the outline that has the color, 0 to 1
  /// Vector from the centroid of that part to the outline's center, pixels.
  Eigen::Vector2d centerFromVisible = Eigen::Vector2d::Zero();

  /// Center of the outline as measured by the region: its centroid, corrected for the expected
  /// hidden part. There must be a region.
  Eigen::Vector2d center() const { return region->centroid + centerFromVisible; }
  /// Share of the target, 0 to 1, that is hidden or outside the image.
  double missing() const { return 1.0 - visible; }
};

/// Measures a target in an image near its expected outline, whose center has the covariance
/// `centerCovariance` (px²). All pieces of the color that overlap with it belong to the target, in
/// full. Labels are computed as needed.
RegionMeasurement measureRegion(LabelImage& labels, const EllipseImage& expected,
                                const Eigen::Matrix2d& centerCovariance);

/// Log likelihood ratio of one image for a target of any shape, against "not there". It compares
/// the target's color inside the expected outline, of which a visible target fills the share
/// `fill`, with its color in a ring around it. The largest value is that of SphereEvidence: one
/// image counts as much for any shape as for a ball.
double regionEvidence(const RegionMeasurement& measurement, double fill);
/// Log likelihood ratio of an image that shows the whole target.
double fullRegionEvidence();

} // namespace dewpoint::observation
