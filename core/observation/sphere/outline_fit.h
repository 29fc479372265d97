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
  LabelImage* labels = nullptr; ///< made wider where the fit needs it; empty: not used
  /// Where the sphere is when this camera looks, relative to the common instant: velocity times the
  /// difference of the capture times; metres.
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
};

/// Where a sphere is, by its outline in all cameras at once.
struct OutlineFit {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();     ///< metres, world
  double radius = 0.0;                                  ///< metres
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< of the center, m²
  double logRadiusVariance = 0.0;                       ///< of log(radius)
  std::vector<int> edges; ///< per camera, spokes on which the outline was found
  bool found = false;     ///< enough of the outline was seen to say
  /// How much the cameras disagree: the sum over the cameras of the squared distance, in standard
  /// deviations, of what each alone would say from what they say together. Its mean is `freedoms`
  /// if the edges' errors are as assumed; far more when a camera is not where it is thought to be.
  double disagreement = 0.0;
  int freedoms = 0; ///< 0 when only one camera sees the outline
  /// How much larger or smaller than expected the outline is: the sum over the cameras of the
  /// squared common offset of the edges, in its standard deviations.
  double sizeMisfit = 0.0;
};

/// What is known before the look.
struct OutlinePrior {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< where to start from
  double radius = 0.0;
  double logRadiusVariance = 0.0; ///< 0: the radius is known and stays
  /// Information (inverse covariance) about the center, 1/m²; zero where nothing is known.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

/// How far from the expected outline edges may lie.
enum class OutlineReach {
  Near, ///< up to half a radius: for a good prediction, beside other things of the color
  Far,  ///< more than a radius, then nearer and nearer: for a guess
};

/// Fits a sphere to the edges of the target's color along spokes from its expected middle, in all
/// cameras together: Gauss-Newton over center (and radius) with Tukey's weights, so that a part
/// that is hidden, or runs into something of the same color, is left out instead of pulling. How
/// far the color reaches at an edge is uncertain by a common amount per camera (anti-aliasing,
/// shading), which is estimated away; so the size in the image speaks of depth only weakly.
OutlineFit fitOutline(const std::vector<OutlineView>& views, const OutlinePrior& prior,
                      OutlineReach reach = OutlineReach::Far);

} // namespace dewpoint::observation
