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

/// How well a rig sees a volume, to be shown: the finished value of an UncertaintyMap.
struct RigMap {
  VolumeGrid grid;
  std::size_t cameraCount = 0; ///< of the rig
  /// Per cell (VolumeGrid::index): standard deviation along the worst direction, meters; NaN where
  /// a point cannot be triangulated.
  std::vector<float> sigmas;
  std::vector<std::uint8_t> counts; ///< cameras that see the cell's center
};

/// A map in three numbers.
struct RigMapSummary {
  double within = 0.0; ///< share of the volume with a sigma of at most the limit, 0 to 1
  double tooFew = 0.0; ///< share that fewer than two cameras see
  /// Half of the volume has a sigma below it, meters; NaN when less than half has one.
  double medianSigma = 0.0;
};
RigMapSummary summaryOf(const RigMap& map, double limit);

/// Cell that a position lies in, an index of RigMap's columns; nothing outside the volume.
std::optional<std::size_t> cellAt(const VolumeGrid& grid, const Eigen::Vector3d& position);

/// A volume cut into about `cellCount` cells that are nearly cubes, at least one along each axis.
VolumeGrid gridOver(const Eigen::AlignedBox3d& volume, std::size_t cellCount);

/// The room that a rig is there for, as far as the project states it: what the reference grid
/// covers, from its floor up. A floor says no height: up to the highest camera, but at most as high
/// as the floor is long and at least a quarter of that. A wall says no depth: as deep as it is
/// long, towards the cameras.
Eigen::AlignedBox3d roomOf(const CameraRig& rig, const ReferenceGrid& grid);

/// Cells of a map that is shown, and that shares are told of: one of six cameras takes some
/// milliseconds.
inline constexpr std::size_t kMapCells = 8640;

/// Cameras of `now`, by index, that see otherwise than those of `before` with the same index, or
/// that are further ones. Names do not matter.
std::vector<std::size_t> changedCameras(const CameraRig& before, const CameraRig& now);

/// Makes maps of a rig that changes: what did not change since the last one is not computed again.
class RigMapper {
public:
  RigMap map(const VolumeGrid& grid, double pixelSigma, const CameraRig& rig);

private:
  std::optional<UncertaintyMap> map_;
  double pixelSigma_ = 0.0;
  CameraRig rig_; ///< in map_
};

} // namespace dewpoint::calibration
