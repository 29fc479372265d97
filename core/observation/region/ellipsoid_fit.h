// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/region/region_measurement.h"
#include "core/observation/region/region_observation.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::observation {

/// Knowledge of a target of any shape before it is measured. World frame.
struct EllipsoidPrior {
  Ellipsoid ellipsoid; ///< start of the fit
  /// Information matrix (inverse covariance) of the center, 1/m²; zero if nothing is known.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); ///< m/s
  /// Standard deviation of each element of the extent, as a share of its trace.
  double extentSigma = 1.0;
};

/// Ellipsoid whose outlines match the target's color in all cameras as well as possible, in center
/// and covariance. World frame.
struct EllipsoidFit {
  bool found = false; ///< at least one camera sees the target; otherwise only `views` is valid
  Ellipsoid ellipsoid;
  /// Covariance of the center, m², including the prior.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  /// Information matrix of the center from the images alone, 1/m². Singular if only one camera sees
  /// the target.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  std::vector<RegionMeasurement> views; ///< one per camera, at the last outline but one
  int seeing = 0;                       ///< number of cameras that see the target
  /// Sum of the squared residuals of the centers, each divided by its standard deviation (which
  /// includes kShapeShare), and the degrees of freedom: residuals minus unknowns. Both are 0 if
  /// only one camera sees the target.
  double disagreement = 0.0;
  int freedoms = 0;
};

/// Standard deviation of the centroid that one camera sees, as a share of the standard deviation of
/// the target's area along each axis. If a body is not an ellipsoid, each camera sees a different
/// centroid, none of which is the centroid of the body. This error stays the same from frame to
/// frame, so EllipsoidFit's covariance does not include it. A judgment (docs/method-dewpoint.md,
/// section 12).
inline constexpr double kShapeShare = 0.15;

/// Fits an ellipsoid to the regions of the target's color. It alternates Gauss-Newton steps over
/// the center, from the centroids of the regions, with linear least squares over the extent, from
/// their covariances. If a target is partly hidden or outside an image, the visible part of the
/// expected outline is compared; its center gets less weight and its covariance is not used.
EllipsoidFit fitEllipsoid(RegionObservation& observation, const EllipsoidPrior& prior);

/// Extent whose outlines match the covariances of the fully visible regions as well as possible.
/// The prior extent is changed no more than these require, because two cameras leave one of its six
/// numbers undetermined.
Eigen::Matrix3d fitExtent(const RegionObservation& observation,
                          const std::vector<RegionMeasurement>& views, const Ellipsoid& before,
                          const EllipsoidPrior& prior);

} // namespace dewpoint::observation
