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

/// Map of how accurately a rig measures in a volume, for display: the values of an UncertaintyMap.
struct RigMap {
  VolumeGrid grid;
  std::size_t cameraCount = 0; ///< number of cameras of the rig
  /// Standard deviation along the worst direction for each cell (VolumeGrid::index), meters; NaN
  /// where a point cannot be triangulated.
  std::vector<float> sigmas;
  std::vector<std::uint8_t> counts; ///< number of cameras that see the center of each cell
};

/// Summary of a map.
struct RigMapSummary {
  double within = 0.0; ///< share of the volume with a sigma of at most `limit` meters, 0 to 1
  double tooFew = 0.0; ///< share of the volume that fewer than two cameras see, 0 to 1
  /// Sigma that half of the volume does not exceed, meters; NaN if less than half has a sigma.
  double medianSigma = 0.0;
};
RigMapSummary summaryOf(const RigMap& map, double limit);

/// Index of the cell that contains a position (world, meters), as in RigMap's columns; nothing
/// outside the volume.
std::optional<std::size_t> cellAt(const VolumeGrid& grid, const Eigen::Vector3d& position);

/// Divides a volume into about `cellCount` nearly cubic cells, at least one along each axis.
VolumeGrid gridOver(const Eigen::AlignedBox3d& volume, std::size_t cellCount);

/// Room for which a rig is made, as far as the project states it: the area of the reference grid,
/// upwards from its floor. A floor grid has no height: the room reaches up to the highest camera,
/// but at most as high as the floor is long, and at least a quarter of that. A wall grid has no
/// depth: the room is as deep as the wall is long, towards the cameras.
Eigen::AlignedBox3d roomOf(const CameraRig& rig, const ReferenceGrid& grid);

/// Number of cells of a map that is displayed, and on which displayed shares are computed. A map
/// for six cameras takes a few milliseconds.
inline constexpr std::size_t kMapCells = 8640;

/// Indices of cameras in `now` whose view differs from the camera with the same index in `before`,
/// or that are additional. Names do not matter.
std::vector<std::size_t> changedCameras(const CameraRig& before, const CameraRig& now);

/// Computes maps of a rig that changes. Unchanged parts of the last map are not computed again.
class RigMapper {
public:
  RigMap map(const VolumeGrid& grid, double pixelSigma, const CameraRig& rig);

private:
  std::optional<UncertaintyMap> map_;
  double pixelSigma_ = 0.0;
  CameraRig rig_; ///< rig of map_
};

} // namespace dewpoint::calibration
