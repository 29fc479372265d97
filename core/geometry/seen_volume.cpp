// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/seen_volume.h"

#include "core/base/statistics.h"
#include "core/geometry/image_bounds.h"
#include "core/geometry/projector.h"
#include "core/geometry/ray.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace dewpoint::geometry {
namespace {

// The lattice on which a view is sampled: rays along each side of the image, and points on a ray.
// Chosen: odd, so that the center of the image is one of them; more change the box by less than the
// distance of two points.
constexpr int kLatticeColumns = 11;
constexpr int kLatticeRows = 9;
constexpr int kLatticeDepths = 32;
/// Farthest point, in distances of the camera from where its axis meets another's. Chosen: the
/// target may be behind what the cameras look at, but seldom far behind.
constexpr double kReachBeyondMeeting = 1.5;
/// The same in greatest distances between cameras, where axes meet far off or never. Chosen: there
/// one pixel of disparity is 3 % of the distance, at a focal length of 600 pixels.
constexpr double kReachInBaselines = 20.0;

/// A camera, and how far it is taken to see.
struct View {
  Projector projector;
  Unprojector unprojector;
  double reach; ///< meters

  bool sees(const Eigen::Vector3d& point) const {
    const auto pixel = projector.project(point);
    return pixel && isInImage(projector.intrinsics(), *pixel) &&
           (point - unprojector.center()).norm() <= reach;
  }
};

bool isUsable(const Camera& camera) {
  const Intrinsics& image = camera.intrinsics;
  return image.width > 0 && image.height > 0 && image.focalX > 0.0 && image.focalY > 0.0 &&
         camera.cameraFromWorld.matrix().allFinite();
}

double greatestDistance(const CameraRig& rig) {
  double greatest = 0.0;
  for (const Camera& one : rig) {
    for (const Camera& other : rig) {
      greatest = std::max(greatest, (one.center() - other.center()).norm());
    }
  }
  return greatest;
}

/// How far a camera of the rig is taken to see, at most `farthest`; meters.
double reachOf(const CameraRig& rig, std::size_t camera, double farthest) {
  std::vector<double> meetings; // distances; the median leaves out axes that are nearly parallel
  for (std::size_t other = 0; other < rig.size(); ++other) {
    if (other == camera) {
      continue;
    }
    if (const auto meeting = nearestPoint({{rig[camera].center(), rig[camera].opticalAxis()},
                                           {rig[other].center(), rig[other].opticalAxis()}})) {
      meetings.push_back((*meeting - rig[camera].center()).norm());
    }
  }
  return meetings.empty() ? farthest
                          : std::min(farthest, kReachBeyondMeeting * upperMedian(meetings));
}

std::vector<View> viewsOf(const CameraRig& rig) {
  const double distance = greatestDistance(rig);
  const double farthest = distance > 0.0 ? kReachInBaselines * distance : kSingleCameraRange;
  std::vector<View> views;
  for (std::size_t camera = 0; camera < rig.size(); ++camera) {
    views.push_back(
        {Projector(rig[camera]), Unprojector(rig[camera]), reachOf(rig, camera, farthest)});
  }
  return views;
}

/// How many of the views see a point that lies on a ray of view number `own`.
std::size_t countSeeing(const std::vector<View>& views, std::size_t own,
                        const Eigen::Vector3d& point) {
  std::size_t count = 1;
  for (std::size_t other = 0; other < views.size(); ++other) {
    count += other != own && views[other].sees(point) ? 1 : 0;
  }
  return count;
}

void extend(std::optional<WorldBox>& box, const Eigen::Vector3d& point) {
  box = box ? WorldBox{box->min.cwiseMin(point), box->max.cwiseMax(point)} : WorldBox{point, point};
}

/// The box of the lattices' points that at least `least` views see.
std::optional<WorldBox> boxOf(const std::vector<View>& views, std::size_t least) {
  std::optional<WorldBox> box;
  for (std::size_t camera = 0; camera < views.size(); ++camera) {
    const View& view = views[camera];
    const Intrinsics& image = view.projector.intrinsics();
    for (int column = 0; column < kLatticeColumns; ++column) {
      for (int row = 0; row < kLatticeRows; ++row) {
        const auto ray = view.unprojector.ray({(image.width - 1.0) * column / (kLatticeColumns - 1),
                                               (image.height - 1.0) * row / (kLatticeRows - 1)});
        for (int depth = 1; ray && depth <= kLatticeDepths; ++depth) {
          const Eigen::Vector3d point =
              ray->origin + view.reach * depth / kLatticeDepths * ray->direction;
          if (countSeeing(views, camera, point) >= least) {
            extend(box, point);
          }
        }
      }
    }
  }
  return box;
}

} // namespace

std::optional<WorldBox> commonVolume(const CameraRig& rig, std::size_t cameras) {
  CameraRig usable;
  std::ranges::copy_if(rig, std::back_inserter(usable), isUsable);
  return boxOf(viewsOf(usable), cameras);
}

std::optional<WorldBox> seenVolume(const CameraRig& rig) {
  const auto common = commonVolume(rig, 2);
  return common ? common : commonVolume(rig, 1);
}

} // namespace dewpoint::geometry
