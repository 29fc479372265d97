// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/planning/uncertainty_map.h"
#include "core/geometry/camera.h"
#include "core/geometry/reference_grid.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// Map for display that shows how accurately a rig measures in a volume. Contains the values of an
/// UncertaintyMap.
struct RigMap {
  VolumeGrid grid;
  std::size_t cameraCount = 0; ///< number of cameras in the rig
  /// Standard deviation of a measured position along the worst direction, for each cell
  /// (VolumeGrid::index), meters; NaN where points cannot be triangulated.
  std::vector<float> sigmas;
  std::vector<std::uint8_t> cameraCounts; ///< number of cameras that see the center of each cell
};

/// Summary of a RigMap: how accurately a rig measures in the volume as a whole.
struct RigMapSummary {
  /// Fraction of the volume, 0 to 1, in which the standard deviation of a measured position is at
  /// most the limit passed to summaryOf().
  double fractionWithinLimit = 0.0;
  /// Fraction of the volume seen by fewer than two cameras, 0 to 1.
  double fractionSeenByTooFew = 0.0;
  /// Median over the volume of the standard deviation of a measured position, meters. NaN if less
  /// than half of the volume has a standard deviation.
  double medianSigma = 0.0;
};
/// Summarizes a map. `limit` is the largest standard deviation of a position that is good enough,
/// in meters.
RigMapSummary summaryOf(const RigMap& map, double limit);

/// Returns the index of the cell that contains a position (world, meters). It is an index in
/// RigMap::sigmas and RigMap::cameraCounts. Returns nothing outside the volume.
std::optional<std::size_t> cellAt(const VolumeGrid& grid, const Eigen::Vector3d& position);

/// Divides a volume into about `cellCount` nearly cubic cells, at least one along each axis.
VolumeGrid gridOver(const Eigen::AlignedBox3d& volume, std::size_t cellCount);

/// Returns the volume in which a rig is planned to measure, derived from the reference grid. For a
/// floor grid, the volume lies above the grid and extends up to the highest camera. Its height is
/// at least a quarter of the length of the floor, and at most its whole length. For a wall grid,
/// the volume extends from the wall towards the cameras by the length of the wall.
Eigen::AlignedBox3d roomVolume(const CameraRig& rig, const ReferenceGrid& grid);

/// Number of cells in a displayed map. Displayed fractions are also computed from these cells. A
/// map for six cameras takes a few milliseconds.
inline constexpr std::size_t kMapCells = 8640;

/// Returns the indices of cameras in `now` that are new or whose view differs from the camera with
/// the same index in `before`. Names are ignored.
std::vector<std::size_t> changedCameras(const CameraRig& before, const CameraRig& now);

/// Computes maps of the accuracy (RigMap) of a rig that changes over time. Reuses the unchanged
/// parts of the last map.
class RigMapper {
public:
  /// Returns the map of the accuracy of a rig, on a grid. `pixelSigma`: standard deviation of an
  /// image measurement, pixels.
  RigMap map(const VolumeGrid& grid, double pixelSigma, const CameraRig& rig);

private:
  std::optional<UncertaintyMap> map_;
  double pixelSigma_ = 0.0;
  CameraRig rig_; ///< rig for which map_ was computed
};

} // namespace dewpoint::calibration
