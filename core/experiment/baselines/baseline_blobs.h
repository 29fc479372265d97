// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/ray.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::experiment {

/// A connected region of matching pixels.
struct Blob {
  Eigen::Vector2d center = Eigen::Vector2d::Zero(); ///< center of mass, pixels (column, row)
  int area = 0;                                     ///< pixels
  cv::Rect box;                                     ///< the pixels it lies in
  /// Of the disk of the same area, pixels.
  double radiusPx() const;
};

/// Smaller regions are noise.
inline constexpr int kMinBlobArea = 4;

/// The 8-connected regions of a mask (CV_8UC1, not 0 where it matches) of at least kMinBlobArea
/// pixels, largest first; of equal ones the upper, then the left one first.
std::vector<Blob> findBlobs(const cv::Mat& mask);

/// Where one camera believes one target is.
struct Bearing {
  std::size_t camera = 0;
  std::size_t blob = 0; ///< index among the camera's blobs
  Ray ray;
  double focalLength = 1.0; ///< pixels
  double radiusPx = 0.0;    ///< apparent size of what is seen there; 0: not known
};

/// A position that bearings of at least two cameras agree on. World frame, meters.
struct TriangulatedPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  /// From the geometry alone: each bearing is off by kCenterSigmaPx across its ray.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double residualPx = 0.0; ///< largest distance of a bearing's ray, in pixels of its camera
  std::vector<Bearing> bearings;
};

/// How well the center of a blob is known, pixels per axis; what the baselines' covariances stand
/// on.
inline constexpr double kCenterSigmaPx = 0.5;

/// Distance of a bearing's ray from a point (world, meters), in pixels of its camera.
double residualPx(const Bearing& bearing, const Eigen::Vector3d& point);

/// Least-squares intersection of the bearings; nothing where nearestPoint() has none.
std::optional<TriangulatedPoint> triangulate(std::vector<Bearing> bearings);

} // namespace dewpoint::experiment
