// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/baselines/baseline_blobs.h"
#include "core/geometry/sphere_image.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::experiment {

/// What one camera shows of a color at one frame.
struct CameraBlobs {
  bool hasImage = false;
  std::vector<Blob> blobs; ///< as from findBlobs(); the first of them are paired
};

/// A position that blobs of several cameras agree on, and how badly it looks like the target: the
/// sum of squared standardized deviations of residual and sizes, and kMissingCost for each camera
/// that should show the target and does not.
struct PairedBlobs {
  TriangulatedPoint point;
  double cost = 0.0;
};

/// Where a target is expected before the images of a frame are considered. World frame, m and m².
struct ExpectedPosition {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  /// Squared Mahalanobis distance beyond which a position is not believed, and taken only when
  /// there is no other; nothing: all are possible, and from kFarSquared on equally so.
  std::optional<double> gate;
};

/// How far a blob's ray may miss the position, pixels...
inline constexpr double kResidualPx = 4.0;
/// ... or, of a large blob, in its radii: a ball of which half is hidden has its center of mass off
/// by 0.42.
inline constexpr double kResidualRadii = 0.5;
/// Greatest ratio of the apparent size to the expected one, either way: what is three quarters
/// hidden looks half as large.
inline constexpr double kSizeFactor = 2.0;
/// Standard deviation of the logarithm of the apparent size: half of a disk hidden is 1.7 of these.
inline constexpr double kSizeSigma = 0.2;
/// Cost of each camera that has an image, and the position in view, but no blob there: as two
/// standard deviations.
inline constexpr double kMissingCost = 4.0;
/// Squared standardized distance from which on an expectation without a gate tells no difference.
inline constexpr double kFarSquared = 9.0;

/// Finds which blobs of different cameras show the same object: by the distance of their rays and
/// by their size. All numbers above are judgments, not tuned.
class BlobPairing {
public:
  explicit BlobPairing(const CameraRig& rig);

  /// Of a pixel of one camera; nothing where the lens model has no ray.
  std::optional<Bearing> bearing(std::size_t camera, std::size_t blob, const Eigen::Vector2d& pixel,
                                 double radiusPx) const;

  /// Every position that at least two cameras agree on: pairs of blobs, and pairs joined by the
  /// nearest blob of each further camera that fits. `radius` is the target's in meters, 0 when it
  /// is not known: then the sizes must agree with each other. Of each camera the largest
  /// 16 + `targetCount` blobs are considered; `cameras` are in the order of the rig.
  std::vector<PairedBlobs> pair(const std::vector<CameraBlobs>& cameras, double radius,
                                std::size_t targetCount) const;

  /// The blob of a camera that fits a position (world, meters) best; nothing if none fits.
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
  std::optional<PairedBlobs> judged(std::vector<Bearing> bearings,
                                    const std::vector<CameraBlobs>& cameras, double radius) const;
  std::vector<Bearing> joined(std::vector<Bearing> members, const Eigen::Vector3d& position,
                              const std::vector<std::vector<Bearing>>& all) const;

  CameraRig rig_;
  std::vector<Unprojector> unprojectors_;
  std::vector<SphereProjector> projectors_;
};

/// The largest residual of some bearings at a position, as a share of what each may have: at most 1
/// when they agree on it.
double residualShare(const std::vector<Bearing>& bearings, const Eigen::Vector3d& position);

/// Which of the pairs each target takes, by the sum of the pair's cost and that of its distance
/// from where the target is expected; the cheapest first, each blob once. Nothing for those that
/// get none.
std::vector<std::optional<TriangulatedPoint>>
assignPairs(const std::vector<PairedBlobs>& pairs, const std::vector<ExpectedPosition>& expected);

} // namespace dewpoint::experiment
