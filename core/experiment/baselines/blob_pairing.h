// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/baselines/baseline_blobs.h"
#include "core/geometry/sphere_image.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::experiment {

/// Blobs (connected regions) of one color in the image of one camera.
struct CameraBlobs {
  bool hasImage = false;
  std::vector<Blob> blobs; ///< largest first, as from findBlobs(); only the largest ones are paired
};

/// Position on which blobs of several cameras agree, with a cost that is higher the less the blobs
/// look like the target. The cost is the sum of the squared standardized deviations of the residual
/// and of the blob sizes, plus kMissingCost for each camera that should show the target but does
/// not.
struct PairedBlobs {
  TriangulatedPoint point;
  double cost = 0.0;
};

/// Expected position of a target before the images of a frame are considered. World frame; mean in
/// m, covariance in m².
struct ExpectedPosition {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  /// Squared Mahalanobis distance beyond which a position is accepted only if there is no other
  /// position. If empty, every position is accepted, and all positions beyond the squared distance
  /// kFarSquared have the same cost.
  std::optional<double> gate;
};

/// Largest accepted distance between a blob's ray and the triangulated position, pixels in the
/// camera's image.
inline constexpr double kMaxResidualPx = 4.0;
/// Largest accepted distance between the ray of a large blob and the triangulated position, in
/// radii of the blob. It applies where it is larger than kMaxResidualPx. For comparison, the center
/// of mass of a half-hidden ball is off by 0.42 radii.
inline constexpr double kMaxResidualRadii = 0.5;
/// Largest factor by which the apparent radius of a blob may be larger or smaller than the expected
/// radius. For comparison, a ball appears to have half its radius when three quarters of it are
/// hidden.
inline constexpr double kMaxSizeRatio = 2.0;
/// Standard deviation of the natural logarithm of a blob's apparent radius. For comparison, hiding
/// half of a disk changes this logarithm by 1.7 standard deviations.
inline constexpr double kSizeSigma = 0.2;
/// Cost for each camera that has an image and sees the position, but has no blob there. It is as
/// high as the cost of a deviation by two standard deviations.
inline constexpr double kMissingCost = 4.0;
/// Squared Mahalanobis distance from an ExpectedPosition without a gate beyond which the cost of a
/// position no longer increases.
inline constexpr double kFarSquared = 9.0;

/// Finds blobs of different cameras that show the same object, by the distances between their rays
/// and by their sizes. The constants in this file were chosen by judgment and not tuned.
class BlobPairing {
public:
  explicit BlobPairing(const CameraRig& rig);

  /// Returns the bearing (the ray through the center) of a blob in the image of a camera, or
  /// nothing if the lens model has no ray at `pixel`. `pixel` is the blob's center, `radiusPx` its
  /// radius, and `blob` its index.
  std::optional<Bearing> makeBearing(std::size_t camera, std::size_t blob,
                                     const Eigen::Vector2d& pixel, double radiusPx) const;

  /// Returns every position on which at least two cameras agree. The result contains each pair of
  /// blobs that fit together, and the same pair extended by the nearest fitting blob of each
  /// additional camera. `radius` is the target radius in meters; if it is 0 (unknown), the blob
  /// sizes only have to agree with each other. Only the largest 16 + `targetCount` blobs of each
  /// camera are considered. `cameras` is in rig order.
  std::vector<PairedBlobs> pairBlobs(const std::vector<CameraBlobs>& cameras, double radius,
                                     std::size_t targetCount) const;

  /// Returns the index of the blob that fits a position (world, meters) best, or nothing if none
  /// fits. `blobs` are the blobs of camera `camera`; `radius` is the target radius in meters, or 0
  /// if it is unknown.
  std::optional<std::size_t> blobAt(std::size_t camera, const std::vector<Blob>& blobs,
                                    const Eigen::Vector3d& position, double radius) const;

private:
  std::vector<std::vector<Bearing>> bearingsOf(const std::vector<CameraBlobs>& cameras,
                                               std::size_t limit) const;
  std::optional<double> impliedRadius(const Bearing& bearing, const Eigen::Vector3d& position,
                                      double radius) const;
  std::optional<double> sizeCost(const std::vector<Bearing>& bearings,
                                 const Eigen::Vector3d& position, double radius) const;
  double missingCost(const TriangulatedPoint& point, const std::vector<CameraBlobs>& cameras) const;
  std::optional<PairedBlobs> evaluatePair(std::vector<Bearing> bearings,
                                          const std::vector<CameraBlobs>& cameras,
                                          double radius) const;
  std::vector<Bearing> extendPair(std::vector<Bearing> members, const Eigen::Vector3d& position,
                                  const std::vector<std::vector<Bearing>>& all) const;

  CameraRig rig_;
  std::vector<Unprojector> unprojectors_;
  std::vector<SphereProjector> projectors_;
};

/// Returns the largest distance between a bearing's ray and a position (world, meters), relative to
/// the allowed distance: kMaxResidualPx, or kMaxResidualRadii for large blobs. The bearings agree
/// on the position if the result is at most 1.
double relativeResidual(const std::vector<Bearing>& bearings, const Eigen::Vector3d& position);

/// Assigns pairs of blobs to targets, and returns the position of each target; empty for a target
/// that gets no pair. The cost of an assignment is the cost of the pair plus the squared
/// Mahalanobis distance between the pair's position and the target's expected position. The
/// assignment with the lowest cost is made first, and each blob is used once.
std::vector<std::optional<TriangulatedPoint>>
assignPairs(const std::vector<PairedBlobs>& pairs, const std::vector<ExpectedPosition>& expected);

} // namespace dewpoint::experiment
