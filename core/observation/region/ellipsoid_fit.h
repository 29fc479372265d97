// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/region/region_measurement.h"
#include "core/observation/region/region_observation.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::observation {

/// Prior knowledge about a target of any shape, for the fit. World frame.
struct EllipsoidPrior {
  Ellipsoid ellipsoid; ///< start of the fit
  /// Information matrix (inverse covariance) of the center, 1/m²; zero if nothing is known.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); ///< velocity of the target, m/s
  /// Standard deviation of each element of the extent matrix, as a fraction of the trace of the
  /// matrix.
  double extentSigma = 1.0;
};

/// Ellipsoid whose outlines best match the center and covariance of the target's color regions in
/// all cameras. World frame.
struct EllipsoidFit {
  /// True if at least one camera sees the target; if false, only `views` is valid.
  bool isFound = false;
  Ellipsoid ellipsoid;
  /// Covariance of the center, m², including the prior.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  /// Information matrix of the center from the images alone, 1/m². Singular if only one camera sees
  /// the target.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  /// Measurements of the target, one per camera, near the outline that was expected before the last
  /// step of the fit.
  std::vector<RegionMeasurement> views;
  int seeingCameraCount = 0; ///< number of cameras that see the target
  /// Disagreement between the cameras: the sum of the squared residuals of the center, each divided
  /// by its standard deviation (including kShapeShare). `degreesOfFreedom` is the number of
  /// residuals minus the number of unknowns. Both are 0 if only one camera sees the target.
  double disagreement = 0.0;
  int degreesOfFreedom = 0;
};

/// Standard deviation of the error of the centroid seen by one camera, as a fraction of the
/// standard deviation of the target's pixels along the same axis. If a body is not an ellipsoid,
/// each camera sees a different centroid, none of which is the centroid of the body. This error
/// stays the same from frame to frame, so EllipsoidFit's covariance does not include it. Chosen by
/// judgment (docs/method-dewpoint.md, section 12).
inline constexpr double kShapeShare = 0.15;

/// Fits an ellipsoid to the regions with the target color. The method alternates between
/// Gauss-Newton steps for the center, based on the region centroids, and linear least squares for
/// the extent, based on the region covariances. If a target is partly hidden or outside an image,
/// its region is compared with the visible part of the expected outline. The center of this region
/// then gets less weight, and the covariance of the region is not used.
EllipsoidFit fitEllipsoid(RegionObservation& observation, const EllipsoidPrior& prior);

/// Returns the extent matrix (m²) of the ellipsoid whose outlines best match the covariances of the
/// fully visible regions. `before` is the current ellipsoid of the fit. The prior extent is changed
/// no more than necessary, because two cameras leave one of the six numbers of the extent
/// undetermined.
Eigen::Matrix3d fitExtent(const RegionObservation& observation,
                          const std::vector<RegionMeasurement>& views, const Ellipsoid& before,
                          const EllipsoidPrior& prior);

} // namespace dewpoint::observation
