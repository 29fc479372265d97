// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/planning/rig_map.h"

#include "core/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dewpoint::calibration {
namespace {

/// The same to a map: names do not matter.
bool haveSameView(const Camera& a, const Camera& b) {
  Camera named = a;
  named.name = b.name;
  return named == b;
}

double highest(const CameraRig& rig) {
  double height = -std::numeric_limits<double>::infinity();
  for (const Camera& camera : rig) {
    height = std::max(height, camera.center().z());
  }
  return height;
}

} // namespace

RigMapSummary summaryOf(const RigMap& map, double limit) {
  std::vector<double> sigmas; // unknown ones after all others
  RigMapSummary summary;
  std::size_t tooFew = 0, within = 0, known = 0;
  for (std::size_t i = 0; i < map.sigmas.size(); ++i) {
    const double sigma = double(map.sigmas[i]);
    tooFew += map.cameraCounts[i] < 2 ? 1 : 0;
    within += sigma <= limit ? 1 : 0; // NaN is not
    known += std::isnan(sigma) ? 0 : 1;
    sigmas.push_back(std::isnan(sigma) ? std::numeric_limits<double>::infinity() : sigma);
  }
  const double count = double(std::max<std::size_t>(map.sigmas.size(), 1));
  summary.fractionWithinLimit = double(within) / count;
  summary.fractionSeenByTooFew = double(tooFew) / count;
  summary.medianSigma = known > map.sigmas.size() / 2 ? upperMedian(std::move(sigmas))
                                                      : std::numeric_limits<double>::quiet_NaN();
  return summary;
}

std::optional<std::size_t> cellAt(const VolumeGrid& grid, const Eigen::Vector3d& position) {
  std::array<int, 3> cell{};
  for (int axis = 0; axis < 3; ++axis) {
    const double share = (position[axis] - grid.low[axis]) / (grid.high[axis] - grid.low[axis]);
    if (!(share >= 0.0 && share <= 1.0)) {
      return std::nullopt;
    }
    const int count = grid.cellsPerAxis[std::size_t(axis)];
    cell[std::size_t(axis)] = std::min(int(share * count), count - 1);
  }
  return grid.index(cell[0], cell[1], cell[2]);
}

VolumeGrid gridOver(const Eigen::AlignedBox3d& volume, std::size_t cellCount) {
  VolumeGrid grid{volume.min(), volume.max(), {1, 1, 1}};
  const Eigen::Vector3d size = volume.sizes();
  // Sides that are much thinner than a cell keep one: their share of the cells goes to the others.
  double edge = std::cbrt(size.prod() / double(std::max<std::size_t>(cellCount, 1)));
  if (!(edge > 0.0)) {
    return grid;
  }
  for (int axis = 0; axis < 3; ++axis) {
    grid.cellsPerAxis[std::size_t(axis)] =
        int(std::clamp(std::round(size[axis] / edge), 1.0, 200.0));
  }
  return grid;
}

Eigen::AlignedBox3d roomVolume(const CameraRig& rig, const ReferenceGrid& grid) {
  const Eigen::Isometry3d worldFromGrid = grid.worldFromGrid();
  const double length = std::max(grid.size.x(), grid.kind == GridKind::Wall ? 0.0 : grid.size.y());
  Eigen::Vector3d low = Eigen::Vector3d::Zero();
  Eigen::Vector3d high = grid.size;
  if (grid.kind == GridKind::Floor) {
    const double up = highest(rig) - grid.origin.z();
    high.z() = std::clamp(std::isfinite(up) ? up : 0.0, 0.25 * length, length);
  } else if (grid.kind == GridKind::Wall) {
    double side = 0.0;
    for (const Camera& camera : rig) {
      side += (worldFromGrid.inverse() * camera.center()).y();
    }
    (side < 0.0 ? low : high).y() = side < 0.0 ? -length : length;
    (side < 0.0 ? high : low).y() = 0.0;
  }
  Eigen::AlignedBox3d room;
  const Eigen::AlignedBox3d own(low, high);
  for (int k = 0; k < 8; ++k) {
    room.extend(worldFromGrid * own.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k)));
  }
  return room;
}

std::vector<std::size_t> changedCameras(const CameraRig& before, const CameraRig& now) {
  std::vector<std::size_t> changed;
  for (std::size_t k = 0; k < now.size(); ++k) {
    if (k >= before.size() || !haveSameView(now[k], before[k])) {
      changed.push_back(k);
    }
  }
  return changed;
}

RigMap RigMapper::map(const VolumeGrid& grid, double pixelSigma, const CameraRig& rig) {
  if (!map_ || map_->grid() != grid || pixelSigma != pixelSigma_) {
    map_.emplace(grid, pixelSigma);
    pixelSigma_ = pixelSigma;
    rig_.clear();
  }
  const std::vector<std::size_t> changed = changedCameras(rig_, rig);
  if (rig.size() < rig_.size() || changed.size() > 1) {
    map_->setRig(rig);
  } else if (changed.size() == 1) {
    map_->setCamera(changed[0], rig[changed[0]]);
  }
  rig_ = rig;
  return {grid, rig.size(), map_->largestSigmas(), map_->cameraCounts()};
}

} // namespace dewpoint::calibration
