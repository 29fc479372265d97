// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/region/region_measurement.h"
#include "core/observation/region/region_observation.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::observation {

/// What is known of a target of any shape before it is measured. World frame.
struct EllipsoidPrior {
  Ellipsoid ellipsoid; ///< where to start from
  /// Information (inverse covariance) about the center, 1/m²; zero where nothing is known.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); ///< m/s
  /// Standard deviation of each element of the extent, as a share of its trace.
  double extentSigma = 1.0;
};

/// An ellipsoid whose outlines have the centers and the second moments of the target's color in all
/// cameras, as far as they can. World frame.
struct EllipsoidFit {
  bool found = false; ///< at least one camera sees the target; else only `views` are valid
  Ellipsoid ellipsoid;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< of the center, m², with the prior
  /// Of the center by the images alone, 1/m²: singular when one camera alone sees the target.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  std::vector<RegionMeasurement> views; ///< one per camera, at the last outline but one
  int seeing = 0;                       ///< cameras that see it
  /// Sum of the squared residuals of the centers, in their standard deviations (with kShapeShare),
  /// and how many more of them there are than unknowns; 0 when one camera alone sees the target.
  double disagreement = 0.0;
  int freedoms = 0;
};

/// Standard deviation of the centroid of what one camera sees of a target, as a share of that of
/// its area along each axis. A body that is no ellipsoid shows each camera another centroid, and
/// not that of its space. It stays so from frame to frame and is not part of EllipsoidFit's
/// covariance. A judgment (docs/method-dewpoint.md, section 12).
inline constexpr double kShapeShare = 0.15;

/// Fits an ellipsoid to the regions of the target's color: Gauss-Newton over its center by the
/// regions' centroids, and linear least squares over its extent by their second moments, in turn.
/// Of a target that is partly hidden, or outside an image, the visible part of the expected outline
/// is compared; its center counts less, its second moments do not.
EllipsoidFit fitEllipsoid(RegionObservation& observation, const EllipsoidPrior& prior);

/// The extent whose outlines come as near as possible to the second moments of the regions, where
/// they are seen whole. The extent of the prior is changed no more than they ask for: two cameras
/// leave one of its six numbers open.
Eigen::Matrix3d fitExtent(const RegionObservation& observation,
                          const std::vector<RegionMeasurement>& views, const Ellipsoid& before,
                          const EllipsoidPrior& prior);

} // namespace dewpoint::observation
