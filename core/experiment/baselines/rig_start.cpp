// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/rig_start.h"

#include "core/geometry/projector.h"
#include "core/geometry/ray.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace dewpoint::experiment {
namespace {

// The lattice on which the common view is sampled: rays per camera, and points per ray.
// Chosen: the points of a desk's view are about 5 cm apart.
constexpr int kColumns = 13;
constexpr int kRows = 9;
constexpr int kDepths = 40;
/// Farthest point of a ray; chosen: the room behind what they look at, too. In distances of the
/// camera from where its axis meets another's.
constexpr double kBeyondMeeting = 2.0;
/// The same in greatest distances between cameras: where the axes meet far off, or never.
constexpr double kBeyondBaseline = 10.0;

double greatestBaseline(const CameraRig& rig) {
  double greatest = 0.0;
  for (const Camera& one : rig) {
    for (const Camera& other : rig) {
      greatest = std::max(greatest, (one.center() - other.center()).norm());
    }
  }
  return greatest;
}

Ray axisOf(const Camera& camera) {
  return {camera.center(), camera.opticalAxis()};
}

/// How far along its rays a camera's view is sampled, meters.
double reachOf(const CameraRig& rig, std::size_t camera) {
  const double farthest = kBeyondBaseline * greatestBaseline(rig);
  double reach = 0.0;
  for (std::size_t other = 0; other < rig.size(); ++other) {
    if (other == camera) {
      continue;
    }
    if (const auto meeting = nearestPoint({axisOf(rig[camera]), axisOf(rig[other])})) {
      reach = std::max(reach, kBeyondMeeting * (*meeting - rig[camera].center()).norm());
    }
  }
  return reach > 0.0 ? std::min(reach, farthest) : farthest;
}

bool sees(const Projector& projector, const Eigen::Vector3d& point) {
  const auto pixel = projector.project(point);
  const Intrinsics& image = projector.intrinsics();
  return pixel && pixel->x() >= 0.0 && pixel->y() >= 0.0 && pixel->x() <= image.width - 1.0 &&
         pixel->y() <= image.height - 1.0;
}

/// Points on the rays of one camera's lattice, up to `reach` meters away.
std::vector<Eigen::Vector3d> pointsBefore(const Camera& camera, double reach) {
  const Unprojector unprojector(camera);
  std::vector<Eigen::Vector3d> points;
  for (int column = 0; column < kColumns; ++column) {
    for (int row = 0; row < kRows; ++row) {
      const auto ray = unprojector.ray({(camera.intrinsics.width - 1.0) * column / (kColumns - 1),
                                        (camera.intrinsics.height - 1.0) * row / (kRows - 1)});
      for (int depth = 1; ray && depth <= kDepths; ++depth) {
        points.emplace_back(ray->origin + reach * depth / kDepths * ray->direction);
      }
    }
  }
  return points;
}

/// The box of the lattices' points that at least `least` cameras see, the camera of the ray among
/// them.
Eigen::AlignedBox3d seenBy(const CameraRig& rig, std::size_t least) {
  const std::vector<Projector> projectors(rig.begin(), rig.end());
  Eigen::AlignedBox3d box;
  for (std::size_t camera = 0; camera < rig.size(); ++camera) {
    for (const Eigen::Vector3d& point : pointsBefore(rig[camera], reachOf(rig, camera))) {
      std::size_t count = 1;
      for (std::size_t other = 0; other < rig.size(); ++other) {
        count += other != camera && sees(projectors[other], point) ? 1 : 0;
      }
      if (count >= least) {
        box.extend(point);
      }
    }
  }
  return box;
}

StartVolume volumeOf(const Eigen::AlignedBox3d& box) {
  return {box.center(), 0.5 * box.sizes()};
}

} // namespace

std::optional<StartVolume> commonView(const CameraRig& rig) {
  if (rig.size() < 2) {
    return std::nullopt;
  }
  Eigen::AlignedBox3d box = seenBy(rig, rig.size());
  if (box.isEmpty()) {
    box = seenBy(rig, 2);
  }
  return box.isEmpty() ? std::nullopt : std::optional(volumeOf(box));
}

StartVolume startFromRig(const ScenarioRun& run) {
  const StartVolume given{run.startCenter, run.startHalf};
  const auto view = commonView(run.rig);
  if (!view) {
    return given;
  }
  if (given.half.isZero()) {
    return *view;
  }
  const Eigen::AlignedBox3d common =
      Eigen::AlignedBox3d(given.center - given.half, given.center + given.half)
          .intersection(Eigen::AlignedBox3d(view->center - view->half, view->center + view->half));
  return common.isEmpty() ? given : volumeOf(common);
}

} // namespace dewpoint::experiment
