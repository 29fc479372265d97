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

/// Connected region of pixels that have the target's color, in the image of one camera.
struct Blob {
  Eigen::Vector2d center = Eigen::Vector2d::Zero(); ///< center of mass, pixels (column, row)
  int areaPx = 0;                                   ///< area, pixels
  cv::Rect box;                                     ///< bounding box
  /// Returns the radius, in pixels, of a disk with the same area as the blob.
  double radiusPx() const;
};

/// Minimum area of a blob, in pixels. Smaller regions are considered noise.
inline constexpr int kMinBlobArea = 4;

/// Finds the 8-connected regions of nonzero pixels in `mask` (CV_8UC1, nonzero where the color
/// matches). Regions smaller than kMinBlobArea are left out. The largest region comes first;
/// regions of equal area are ordered from top to bottom, then from left to right.
std::vector<Blob> findBlobs(const cv::Mat& mask);

/// Ray along which a camera sees the center of a blob (a region of the target's color).
struct Bearing {
  std::size_t camera = 0;
  std::size_t blob = 0; ///< index among the camera's blobs
  Ray ray;
  double focalLengthPx = 1.0; ///< focal length of the camera, pixels
  double radiusPx = 0.0;      ///< apparent blob radius, pixels; 0 if unknown
};

/// Position at which the bearings (rays) of at least two cameras almost meet. World frame, meters.
struct TriangulatedPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  /// Covariance (m²) of the position, computed from the directions of the rays under the assumption
  /// that each ray has an error of kCenterSigmaPx.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  /// Largest distance of a bearing's ray from the position, converted to pixels; see residualPx().
  double residualPx = 0.0;
  std::vector<Bearing> bearings;
};

/// Standard deviation of the error of a blob's center along each image axis, in pixels. The
/// baseline methods compute their covariances from this value.
inline constexpr double kCenterSigmaPx = 0.5;

/// Returns the distance between the ray of a bearing and a point (world, meters), converted to
/// pixels in the camera's image.
double residualPx(const Bearing& bearing, const Eigen::Vector3d& point);

/// Computes the point that is nearest to the rays of all bearings, by least squares
/// (nearestPoint()). Returns nothing if there is no such point, for example because the rays are
/// parallel.
std::optional<TriangulatedPoint> triangulate(std::vector<Bearing> bearings);

} // namespace dewpoint::experiment
