// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/ellipsoid_image.h"
#include "core/observation/region/color_region.h"

#include <Eigen/Core>

#include <optional>

namespace dewpoint::observation {

/// Measurement of a target of any shape in one image, near its expected outline. Pixels.
struct RegionMeasurement {
  bool isInView = false; ///< the camera has an image that contains the outline's center
  /// Outline that is expected for the target.
  EllipseImage expectedOutline;
  std::optional<ColorRegion>
      region; ///< region assigned to the target; empty if the target is not seen
  /// Fraction of the expected outline's area, 0 to 1, in which the target color could be seen:
  /// inside the image, and not behind an object that may hide the target.
  double visibleShare = 0.0;
  double matchedShare = 0.0; ///< fraction of the visible part that has the target color, 0 to 1
  /// Fraction of a ring around the outline that has the target color, 0 to 1.
  double ringMatchShare = 0.0;
  /// Vector from the centroid of the visible part to the outline's center, pixels.
  Eigen::Vector2d centerFromVisible = Eigen::Vector2d::Zero();

  /// Returns the center of the outline as measured in the image: the centroid of the region,
  /// corrected for the part of the outline that is expected to be hidden. `region` must not be
  /// empty.
  Eigen::Vector2d center() const { return region->centroid + centerFromVisible; }
  /// Returns the fraction of the target, 0 to 1, that is hidden or outside the image.
  double missingShare() const { return 1.0 - visibleShare; }
};

/// Measures a target in an image near its expected outline. `centerCovariance` (px²) is the
/// covariance of the center of the expected outline. Every piece with the target color that
/// overlaps the outline is assigned completely to the target. Labels are computed as needed.
RegionMeasurement measureRegion(LabelImage& labels, const EllipseImage& expected,
                                const Eigen::Matrix2d& centerCovariance);

/// Returns the log likelihood ratio of one image for a target of any shape: "the target is at the
/// expected outline" against "the target is not there". The ratio depends on which fraction of the
/// pixels inside the expected outline have the target color, and which fraction of the pixels in a
/// ring around the outline. `fill` is the fraction to expect inside the outline if the target is
/// visible. The largest ratio equals the largest ratio that SphereEvidence computes for a ball, so
/// that an image has the same influence for a target of any shape as for a ball.
double regionEvidence(const RegionMeasurement& measurement, double fill);
/// Returns the value of regionEvidence() for an image that shows the whole target.
double fullRegionEvidence();

} // namespace dewpoint::observation
