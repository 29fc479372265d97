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

/// A box of the world divided into cells. Values computed for a cell are those at its center.
struct VolumeGrid {
  Eigen::Vector3d low = Eigen::Vector3d::Zero(); ///< meters
  Eigen::Vector3d high = Eigen::Vector3d::Ones();
  std::array<int, 3> cells{1, 1, 1};

  std::size_t cellCount() const {
    return std::size_t(cells[0]) * std::size_t(cells[1]) * std::size_t(cells[2]);
  }
  /// Index of a cell: x varies fastest, then y, then z.
  std::size_t index(int x, int y, int z) const {
    return std::size_t(x) +
           std::size_t(cells[0]) * (std::size_t(y) + std::size_t(cells[1]) * std::size_t(z));
  }
  /// Center of a cell, world, meters.
  Eigen::Vector3d center(int x, int y, int z) const;

  bool operator==(const VolumeGrid&) const = default;
};

/// Covariance of a camera's pose error (w, s), where the true cameraFromWorld is (1 + [w]x) R, t +
/// s, about the camera's own center: rotation in camera axes (rad), then displacement in camera
/// axes (m).
using PoseCovariance = Eigen::Matrix<double, 6, 6>;

/// Pose covariance of a camera whose direction is known to `angle` (rad) and whose position is
/// known to `distance` (m), per axis.
PoseCovariance poseCovariance(double angle, double distance);

/// Expected error of a triangulated point over a volume: the map of the rig planner.
///
/// A camera that sees the point X contributes the information Jᵀ (σ² I + K C Kᵀ)⁻¹ J, where J =
/// d(pixel) / dX of its own lens (central differences), K = d(pixel)/d(pose), and C is the
/// covariance of its pose. The point's covariance is the inverse of the sum over cameras (Hartley &
/// Zisserman, Multiple View Geometry, 5.2, first order). Errors of different cameras are assumed
/// independent, and no point is occluded. The contribution of each camera is stored: when one
/// camera is moved, only its contribution is computed again.
class UncertaintyMap {
public:
  /// `pixelSigma`: standard deviation of a measurement in an image, pixels.
  UncertaintyMap(const VolumeGrid& grid, double pixelSigma);

  /// Sets all cameras. `covariances` is empty (exact poses), or has one entry per camera.
  void setRig(const CameraRig& rig, std::span<const PoseCovariance> covariances = {});
  /// Replaces one camera of the rig, or adds the next one.
  void setCamera(std::size_t camera, const Camera& moved,
                 const PoseCovariance& covariance = PoseCovariance::Zero());

  const VolumeGrid& grid() const { return grid_; }
  /// Number of cameras that see the center of each cell. This and the following have one value per
  /// cell, by VolumeGrid::index.
  const std::vector<std::uint8_t>& cameraCounts() const { return counts_; }
  /// Standard deviation along the worst direction, meters; NaN where fewer than two cameras see the
  /// center, or all that see it look along one line.
  const std::vector<float>& largestSigmas() const { return largest_; }
  /// Standard deviations along x, y and z of the world, meters; NaN as in largestSigmas().
  const std::vector<std::array<float, 3>>& axisSigmas() const { return axes_; }

  /// Values of largestSigmas() in one horizontal layer of cells, x varying fastest.
  std::span<const float> layer(int z) const;
  /// Layer that contains a height (meters); nothing outside the volume.
  std::optional<int> layerAt(double height) const;
  /// Share of the cells (0 to 1) that at least two cameras see and whose largest sigma is at most
  /// `sigma` meters.
  double shareWithin(double sigma) const;

private:
  /// Symmetric 3 x 3 matrices as xx xy xz yy yz zz for all cells, and whether the camera sees the
  /// cells.
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
