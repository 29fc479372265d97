// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/sphere_image.h"
#include "core/observation/background/label_image.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace dewpoint::observation {

/// One camera of an outline fit.
struct OutlineView {
  const SphereProjector* projector = nullptr;
  LabelImage* labels = nullptr; ///< more are computed as needed; empty: not used
  /// Displacement of the sphere (meters) between the frame's time and this camera's exposure: its
  /// velocity times the time difference.
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
};

/// Position of a sphere, fitted to its outlines in all cameras together.
struct OutlineFit {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();     ///< meters, world
  double radius = 0.0;                                  ///< meters
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< covariance of the center, m²
  double logRadiusVariance = 0.0;                       ///< variance of log(radius)
  std::vector<int> edges; ///< per camera, number of spokes on which the outline was found
  bool found = false;     ///< enough of the outline was seen; otherwise nothing else is valid
  /// Disagreement of the cameras: the sum over the cameras of the squared Mahalanobis distance
  /// between the position from one camera alone and the position from all. Its mean is `freedoms`
  /// if the errors of the edges are as assumed. It is far larger if a camera was moved.
  double disagreement = 0.0;
  int freedoms = 0; ///< 0 if only one camera sees the outline
  /// Difference of the outline from its expected size: the sum over the cameras of the squared
  /// common offset of the edges, divided by its variance.
  double sizeMisfit = 0.0;
};

/// Knowledge before the fit. World frame.
struct OutlinePrior {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< start of the fit, meters
  double radius = 0.0;
  double logRadiusVariance = 0.0; ///< 0: the radius is known and fixed
  /// Information matrix (inverse covariance) of the center, 1/m²; zero if nothing is known.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

/// Largest distance of edges from the expected outline.
enum class OutlineReach {
  Near, ///< up to half a radius: for a good prediction, beside other objects of the color
  Far,  ///< more than a radius, then step by step less: for a rough start
};

/// Fits a sphere to the edges of the target's color along spokes from its expected center, in all
/// cameras together. Method: Gauss-Newton over center (and radius) with Tukey's weights, so that a
/// part that is hidden, or touches another object of the same color, is left out and does not bias
/// the fit. The reach of the color at an edge is uncertain by a common amount per camera
/// (anti-aliasing, shading), which is estimated as well. The size in the image therefore determines
/// the depth only weakly.
OutlineFit fitOutline(const std::vector<OutlineView>& views, const OutlinePrior& prior,
                      OutlineReach reach = OutlineReach::Far);

} // namespace dewpoint::observation
