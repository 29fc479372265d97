// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/sphere_image.h"
#include "core/observation/background/label_image.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace dewpoint::observation {

/// Input of an outline fit from one camera.
struct OutlineView {
  const SphereProjector* projector = nullptr;
  /// Labels of the camera's image. Missing labels are computed as needed. A camera without an image
  /// has empty labels and is not used.
  LabelImage* labels = nullptr;
  /// Displacement of the sphere (meters, world) from the frame time to this camera's exposure: the
  /// velocity of the sphere times the time difference.
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
};

/// Information about the center of the sphere from the image of one camera alone, linearized at
/// OutlineFit::center. If this camera sees the sphere displaced by d (meters, world) from that
/// center, the expected value of `vector` is information * d.
struct CameraInformation {
  /// Inverse covariance of the center, 1/m²; zero if the camera does not show the outline.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  /// Product of `information` and the displacement (meters, world) that this camera alone suggests
  /// for the center; 1/m.
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
};

/// Sphere fitted jointly to its outlines in all cameras.
struct OutlineFit {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();     ///< meters, world
  double radius = 0.0;                                  ///< meters
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< covariance of the center, m²
  double logRadiusVariance = 0.0;                       ///< variance of log(radius)
  std::vector<int> edgeCounts; ///< number of spokes on which the outline was found, per camera
  /// True if enough of the outline was seen; if false, no other field is valid.
  bool isFound = false;
  /// Disagreement between the cameras. For each camera, the position is also computed from this
  /// camera alone. The disagreement is the sum of the squared Mahalanobis distances of these
  /// positions from `center`. The disagreement is `degreesOfFreedom` on average if the edge errors
  /// are as assumed, and much larger if a camera was moved.
  double disagreement = 0.0;
  /// Value that `disagreement` has on average; 0 if only one camera sees the outline.
  int degreesOfFreedom = 0;
  /// Deviation of the outlines from their expected size: the mean offset of all edges in a camera,
  /// squared and divided by its variance, summed over the cameras.
  double sizeDeviation = 0.0;
  /// Information from each camera alone, one entry per camera.
  std::vector<CameraInformation> cameraInformation;
};

/// Prior knowledge about the sphere, for the fit. World frame.
struct OutlinePrior {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< start of the fit, meters
  double radius = 0.0;
  double logRadiusVariance = 0.0; ///< variance of log(radius); 0: the radius is known and fixed
  /// Information matrix (inverse covariance) of the center, 1/m²; zero if nothing is known.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

/// Largest distance from the expected outline at which edges are sought.
enum class EdgeSearchRange {
  Near, ///< up to half a radius; used with a good prediction near other objects of the same color
  Far,  ///< more than a radius at first, reduced step by step; used with a rough start
};

/// Fits a sphere jointly to its outlines in all cameras. The edges of the target color are found
/// along spokes, which are rays in the image from the expected center of the outline. The center
/// (and the radius, unless it is known) is fitted by Gauss-Newton steps with Tukey's weights. Edges
/// where the outline is hidden, or where it touches another object of the same color, get no weight
/// and do not bias the fit. Anti-aliasing and shading shift all edges in a camera by an unknown
/// common amount. This shift is also estimated, so the size of the outline determines the depth
/// only weakly. `isFound` is false in the result if too little of the outline was seen.
OutlineFit fitOutline(const std::vector<OutlineView>& views, const OutlinePrior& prior,
                      EdgeSearchRange reach = EdgeSearchRange::Far);

} // namespace dewpoint::observation
