// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/baselines/baseline_blobs.h"
#include "core/geometry/sphere_image.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::experiment {

/// Blobs of one color in one camera image.
struct CameraBlobs {
  bool hasImage = false;
  std::vector<Blob> blobs; ///< ordered as by findBlobs(); only the first ones are paired
};

/// Position on which blobs of several cameras agree. A high cost means that it looks unlike the
/// target. The cost is the sum of the squared standardized deviations of residual and sizes, plus
/// kMissingCost for each camera that should show the target but does not.
struct PairedBlobs {
  TriangulatedPoint point;
  double cost = 0.0;
};

/// Expected position of a target before the images of a frame are considered. World frame; mean in
/// m, covariance in m².
struct ExpectedPosition {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  /// Squared Mahalanobis distance beyond which a position is accepted only if there is no other. If
  /// empty, all positions are possible, and positions beyond kFarSquared are equally likely.
  std::optional<double> gate;
};

/// Largest distance between a blob's ray and the position, pixels.
inline constexpr double kMaxResidualPx = 4.0;
/// The same limit for large blobs, in blob radii. The center of mass of a half-hidden ball is off
/// by 0.42 radii.
inline constexpr double kMaxResidualRadii = 0.5;
/// Largest ratio between apparent and expected size, in both directions. A ball that is three
/// quarters hidden appears half as large.
inline constexpr double kMaxSizeRatio = 2.0;
/// Standard deviation of the logarithm of the apparent size. Hiding half of a disk shifts it by 1.7
/// standard deviations.
inline constexpr double kSizeSigma = 0.2;
/// Cost for each camera that has an image and the position in view, but no blob there. It equals
/// the cost of a deviation by two standard deviations.
inline constexpr double kMissingCost = 4.0;
/// Squared standardized distance beyond which an expectation without a gate has no effect.
inline constexpr double kFarSquared = 9.0;

/// Finds blobs of different cameras that show the same object, by the distance of their rays and by
/// their size. All constants above were chosen by judgment and not tuned.
class BlobPairing {
public:
  explicit BlobPairing(const CameraRig& rig);

  /// Returns the bearing of a pixel in one camera, or nothing if the lens model has no ray there.
  std::optional<Bearing> bearing(std::size_t camera, std::size_t blob, const Eigen::Vector2d& pixel,
                                 double radiusPx) const;

  /// Finds every position on which at least two cameras agree: pairs of blobs, and pairs extended
  /// by the nearest fitting blob of each additional camera. `radius` is the target radius in
  /// meters. If it is unknown (0), the sizes must agree with each other. Only the largest 16 +
  /// `targetCount` blobs of each camera are considered. `cameras` is in rig order.
  std::vector<PairedBlobs> pair(const std::vector<CameraBlobs>& cameras, double radius,
                                std::size_t targetCount) const;

  /// Returns the index of a camera's blob that fits a position (world, meters) best, or nothing if
  /// none fits.
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

/// Returns the largest residual of the bearings at a position, as a fraction of the allowed
/// residual. It is at most 1 if the bearings agree.
double relativeResidual(const std::vector<Bearing>& bearings, const Eigen::Vector3d& position);

/// Assigns pairs to targets by the cost of the pair plus the cost of its distance from the expected
/// position. The cheapest is assigned first, and each blob is used once. Targets without a pair get
/// nothing.
std::vector<std::optional<TriangulatedPoint>>
assignPairs(const std::vector<PairedBlobs>& pairs, const std::vector<ExpectedPosition>& expected);

} // namespace dewpoint::experiment
