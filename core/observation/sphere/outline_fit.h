// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/sphere_image.h"
#include "core/observation/background/label_image.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace dewpoint::observation {

/// One camera's part in an outline fit.
struct OutlineView {
  const SphereProjector* projector = nullptr;
  LabelImage* labels = nullptr; ///< more labels are made where the fit needs them; empty: not used
  /// Displacement of the sphere (meters) between the frame's time and this camera's exposure: its
  /// velocity times the difference of the times.
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
};

/// The position of a sphere, from its outline in all cameras together.
struct OutlineFit {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();     ///< meters, world
  double radius = 0.0;                                  ///< meters
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< of the center, m²
  double logRadiusVariance = 0.0;                       ///< of log(radius)
  std::vector<int> edges; ///< per camera, spokes on which the outline was found
  bool found = false;     ///< enough of the outline was seen; else nothing else is valid
  /// The disagreement of the cameras: the sum over the cameras of the squared Mahalanobis distance
  /// between the position by one camera alone and that by all. Its mean is `freedoms` if the edges'
  /// errors are as assumed; it is far larger when a camera was moved.
  double disagreement = 0.0;
  int freedoms = 0; ///< 0 when only one camera sees the outline
  /// How much larger or smaller than expected the outline is: the sum over the cameras of the
  /// squared common offset of the edges, in its standard deviations.
  double sizeMisfit = 0.0;
};

/// What is known before the fit.
struct OutlinePrior {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< where to start from
  double radius = 0.0;
  double logRadiusVariance = 0.0; ///< 0: the radius is known and stays
  /// Information (inverse covariance) about the center, 1/m²; zero where nothing is known.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

/// How far from the expected outline edges may lie.
enum class OutlineReach {
  Near, ///< up to half a radius: for a good prediction, beside other objects of the color
  Far,  ///< more than a radius, then nearer and nearer: for a rough start
};

/// Fits a sphere to the edges of the target's color along spokes from its expected center, in all
/// cameras together: Gauss-Newton over center (and radius) with Tukey's weights, so that a part
/// that is hidden, or runs into something of the same color, is left out instead of pulling. How
/// far the color reaches at an edge is uncertain by a common amount per camera (anti-aliasing,
/// shading), which is estimated away; so the size in the image determines the depth only weakly.
OutlineFit fitOutline(const std::vector<OutlineView>& views, const OutlinePrior& prior,
                      OutlineReach reach = OutlineReach::Far);

} // namespace dewpoint::observation
