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

/// Box in the world divided into cells. Values for a cell are computed at its center.
struct VolumeGrid {
  Eigen::Vector3d low = Eigen::Vector3d::Zero(); ///< lower corner, meters
  Eigen::Vector3d high = Eigen::Vector3d::Ones();
  std::array<int, 3> cellsPerAxis{1, 1, 1};

  std::size_t cellCount() const {
    return std::size_t(cellsPerAxis[0]) * std::size_t(cellsPerAxis[1]) *
           std::size_t(cellsPerAxis[2]);
  }
  /// Returns the index of a cell: x varies fastest, then y, then z.
  std::size_t index(int x, int y, int z) const {
    return std::size_t(x) + std::size_t(cellsPerAxis[0]) *
                                (std::size_t(y) + std::size_t(cellsPerAxis[1]) * std::size_t(z));
  }
  /// Returns the center of a cell; world, meters.
  Eigen::Vector3d center(int x, int y, int z) const;

  bool operator==(const VolumeGrid&) const = default;
};

/// Covariance of the error (w, s) of a camera's pose: w is a rotation vector in camera axes (rad)
/// about the camera's center, and s is a displacement in camera axes (m). If the estimated
/// cameraFromWorld has the rotation R and the translation t, the true one has the rotation (I +
/// [w]x) R and the translation t + s.
using PoseCovariance = Eigen::Matrix<double, 6, 6>;

/// Returns the pose covariance of a camera whose direction has the standard deviation `angle` (rad)
/// and whose position has the standard deviation `distance` (m), per axis.
PoseCovariance poseCovariance(double angle, double distance);

/// Expected error of a triangulated point throughout a volume: the map shown by the rig planner.
///
/// A camera that sees the point X contributes the information Jᵀ (σ² I + K C Kᵀ)⁻¹ J, where J =
/// d(pixel) / dX for its own lens (central differences), K = d(pixel)/d(pose), and C is the
/// covariance of its pose. The covariance of the point is the inverse of the sum over cameras
/// (Hartley & Zisserman, Multiple View Geometry, 5.2, first order). Errors of different cameras are
/// assumed to be independent, and no point is occluded. The contribution of each camera is stored,
/// so that moving one camera requires recomputing only its own contribution.
class UncertaintyMap {
public:
  /// `pixelSigma`: standard deviation of an image measurement, pixels.
  UncertaintyMap(const VolumeGrid& grid, double pixelSigma);

  /// Sets all cameras. `covariances` is empty for exact poses, or has one entry per camera.
  void setRig(const CameraRig& rig, std::span<const PoseCovariance> covariances = {});
  /// Replaces the camera with the index `camera`. If this index is equal to the number of cameras,
  /// adds a camera.
  void setCamera(std::size_t camera, const Camera& moved,
                 const PoseCovariance& covariance = PoseCovariance::Zero());

  const VolumeGrid& grid() const { return grid_; }
  /// Returns, for each cell, the number of cameras that see its center; indexed by
  /// VolumeGrid::index.
  const std::vector<std::uint8_t>& cameraCounts() const { return counts_; }
  /// Returns, for each cell, the standard deviation of a triangulated point along the worst
  /// direction, meters; indexed by VolumeGrid::index. NaN if fewer than two cameras see the center
  /// of the cell, or if all cameras that see it look along the same line.
  const std::vector<float>& largestSigmas() const { return largest_; }
  /// Returns, for each cell, the standard deviations of a triangulated point along x, y and z in
  /// the world, meters; indexed by VolumeGrid::index. NaN where points cannot be triangulated
  /// (largestSigmas()).
  const std::vector<std::array<float, 3>>& axisSigmas() const { return axes_; }

  /// Returns the standard deviations along the worst direction (largestSigmas()) in the horizontal
  /// layer `z` of cells, x varying fastest.
  std::span<const float> layer(int z) const;
  /// Returns the index z of the layer that contains a height (world z, meters), or nothing outside
  /// the volume.
  std::optional<int> layerAt(double height) const;
  /// Returns the fraction of all cells (0 to 1) that at least two cameras see and in which the
  /// standard deviation of a triangulated point along the worst direction is at most `sigma`
  /// meters.
  double fractionWithin(double sigma) const;

private:
  /// What one camera contributes to each cell: its information matrix (symmetric 3 x 3, stored as
  /// xx xy xz yy yz zz), and whether it sees the cell.
  struct Information {
    std::vector<std::array<float, 6>> matrices;
    std::vector<std::uint8_t> isSeen;
  };
  void compute(const Camera& camera, const PoseCovariance& covariance, Information& information);
  void combine();

  VolumeGrid grid_;
  double pixelSigma_;
  std::vector<double> x_, y_, z_; ///< cell centers, meters
  std::vector<Information> cameras_;
  std::vector<std::uint8_t> counts_;
  std::vector<float> largest_;
  std::vector<std::array<float, 3>> axes_;
};

} // namespace dewpoint::calibration
