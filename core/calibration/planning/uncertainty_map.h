// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace dewpoint::calibration {

/// A box of the world cut into cells; what is computed for a cell holds at its center.
struct VolumeGrid {
  Eigen::Vector3d low = Eigen::Vector3d::Zero(); ///< meters
  Eigen::Vector3d high = Eigen::Vector3d::Ones();
  std::array<int, 3> cells{1, 1, 1};

  std::size_t cellCount() const {
    return std::size_t(cells[0]) * std::size_t(cells[1]) * std::size_t(cells[2]);
  }
  /// x runs fastest, then y, then z.
  std::size_t index(int x, int y, int z) const {
    return std::size_t(x) +
           std::size_t(cells[0]) * (std::size_t(y) + std::size_t(cells[1]) * std::size_t(z));
  }
  Eigen::Vector3d center(int x, int y, int z) const;

  bool operator==(const VolumeGrid&) const = default;
};

/// Covariance of a camera's pose, of the small vector (w, s) in (1 + [w]x) R, t + s of
/// cameraFromWorld, about the camera's own center: rotation in camera axes (rad), then shift of the
/// camera in camera axes (m).
using PoseCovariance = Eigen::Matrix<double, 6, 6>;

/// The one of a camera whose direction is known to `angle` (rad) and whose position to `distance`
/// (m), per axis.
PoseCovariance poseCovariance(double angle, double distance);

/// How far a triangulated point is expected to be off, over a volume: the rig planner's map.
///
/// A camera that sees the point X gives the information Jᵀ (σ² I + K C Kᵀ)⁻¹ J about it, J =
/// d(pixel) / dX of its own lens (central differences), K = d(pixel)/d(pose), C the covariance of
/// its pose; the point's covariance is the inverse of their sum (Hartley & Zisserman, Multiple View
/// Geometry, 5.2, first order). Errors of different cameras count as independent, and nothing hides
/// the point. What each camera gives is kept: when one is moved, only that one is recomputed.
class UncertaintyMap {
public:
  UncertaintyMap(const VolumeGrid& grid, double pixelSigma);

  /// All cameras. `covariances` is empty (exact poses), or has one per camera.
  void setRig(const CameraRig& rig, std::span<const PoseCovariance> covariances = {});
  /// One camera of the rig, moved; or the next one, to add it.
  void setCamera(std::size_t camera, const Camera& moved,
                 const PoseCovariance& covariance = PoseCovariance::Zero());

  const VolumeGrid& grid() const { return grid_; }
  /// One value per cell, VolumeGrid::index.
  /// Cameras that see the cell's center.
  const std::vector<std::uint8_t>& cameraCounts() const { return counts_; }
  /// Standard deviation along the worst direction, meters; NaN where fewer than two cameras see it,
  /// or those that do look along one line.
  const std::vector<float>& largestSigmas() const { return largest_; }
  /// Standard deviations along x, y and z of the world, meters; NaN likewise.
  const std::vector<std::array<float, 3>>& axisSigmas() const { return axes_; }

  /// A layer of cells of one height, x fastest: largestSigmas() of it.
  std::span<const float> layer(int z) const;
  /// The layer that the height lies in; nothing outside the volume.
  std::optional<int> layerAt(double height) const;
  /// The share of the cells (0 to 1) that at least two cameras see with a largest sigma of at most
  /// `sigma` meters.
  double shareWithin(double sigma) const;

private:
  /// Symmetric 3 x 3 by xx xy xz yy yz zz, for all cells; and whether the camera sees them.
  struct Information {
    std::vector<std::array<float, 6>> matrices;
    std::vector<std::uint8_t> seen;
  };
  void compute(const Camera& camera, const PoseCovariance& covariance, Information& information);
  void combine();

  VolumeGrid grid_;
  double pixelSigma_;
  std::vector<double> x_, y_, z_; ///< centers of the cells
  std::vector<Information> cameras_;
  std::vector<std::uint8_t> counts_;
  std::vector<float> largest_;
  std::vector<std::array<float, 3>> axes_;
};

} // namespace dewpoint::calibration
