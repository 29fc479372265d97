// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/quality/common_view.h"

#include "core/base/statistics.h"
#include "core/geometry/image_bounds.h"
#include "core/geometry/mean_vector.h"
#include "core/geometry/projector.h"
#include "core/geometry/ray.h"
#include "core/geometry/small_matrices.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <optional>
#include <utility>

namespace dewpoint::calibration {
namespace {

constexpr int kLatticeSide = 16;
constexpr double kViewEnd = 1.25;       ///< times the distance of the targets
constexpr double kTargetsWithin = 0.95; ///< share of the targets that are nearer than that distance

/// View of one camera, up to a distance.
struct BoundedView {
  std::size_t camera = 0;
  Projector projector;
  Eigen::Vector3d center;
  double reach = 0.0; ///< meters

  bool sees(const Eigen::Vector3d& position) const {
    if ((position - center).norm() > reach) {
      return false;
    }
    const auto pixel = projector.project(position);
    return pixel && isInImage(projector.intrinsics(), *pixel);
  }
};

std::vector<BoundedView> boundedViews(const CameraRig& rig,
                                      const std::vector<Eigen::Vector3d>& targets) {
  std::vector<BoundedView> views;
  for (std::size_t c = 0; c < rig.size(); ++c) {
    BoundedView view{c, Projector(rig[c]), rig[c].center(), 0.0};
    std::vector<double> distances;
    for (const Eigen::Vector3d& target : targets) {
      const auto pixel = view.projector.project(target);
      if (pixel && isInImage(rig[c].intrinsics, *pixel)) {
        distances.push_back((target - view.center).norm());
      }
    }
    if (!distances.empty()) {
      std::ranges::sort(distances);
      view.reach = kViewEnd * quantile(distances, kTargetsWithin);
      views.push_back(std::move(view));
    }
  }
  return views;
}

/// The box around all views: their cameras, and the ends of rays through 3 x 3 pixels.
Eigen::AlignedBox3d boxAround(const CameraRig& rig, const std::vector<BoundedView>& views) {
  Eigen::AlignedBox3d box;
  for (const BoundedView& view : views) {
    const Intrinsics& image = rig[view.camera].intrinsics;
    const Unprojector unprojector(rig[view.camera]);
    box.extend(view.center);
    for (const double x : {0.0, 0.5, 1.0}) {
      for (const double y : {0.0, 0.5, 1.0}) {
        const auto along =
            unprojector.worldDirection({x * (image.width - 1.0), y * (image.height - 1.0)});
        if (along) {
          box.extend(view.center + view.reach * *along);
        }
      }
    }
  }
  return box;
}

} // namespace

CommonView findCommonView(const CameraRig& rig, const std::vector<Eigen::Vector3d>& targets) {
  CommonView common;
  const auto views = boundedViews(rig, targets);
  if (views.size() < 2) {
    return common;
  }
  const Eigen::AlignedBox3d box = boxAround(rig, views);
  const auto at = [&](int axis, int k) {
    return box.min()[axis] + (k + 0.5) / kLatticeSide * box.sizes()[axis];
  };
  for (int z = 0; z < kLatticeSide; ++z) {
    for (int y = 0; y < kLatticeSide; ++y) {
      for (int x = 0; x < kLatticeSide; ++x) {
        const Eigen::Vector3d position(at(0, x), at(1, y), at(2, z));
        std::vector<std::size_t> seeing;
        for (const BoundedView& view : views) {
          if (view.sees(position)) {
            seeing.push_back(view.camera);
          }
        }
        if (seeing.size() > 1) {
          common.positions.push_back(position);
          common.camerasPerPosition.push_back(std::move(seeing));
        }
      }
    }
  }
  return common;
}

double PrincipalBox::distanceTo(const Eigen::Vector3d& position) const {
  const Eigen::Vector3d along = axes.transpose() * (position - center);
  return (low - along).cwiseMax(along - high).cwiseMax(0.0).norm();
}

PrincipalBox principalBox(const std::vector<Eigen::Vector3d>& positions, double outliers) {
  PrincipalBox box;
  if (positions.empty()) {
    return box;
  }
  box.center = meanVector(positions);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& position : positions) {
    spread += (position - box.center) * (position - box.center).transpose();
  }
  const Eigen::Matrix3d vectors = symmetricEigen3(spread).vectors;
  for (int axis = 0; axis < 3; ++axis) {
    box.axes.col(axis) = vectors.col(2 - axis);
    std::vector<double> along;
    along.reserve(positions.size());
    for (const Eigen::Vector3d& position : positions) {
      along.push_back(box.axes.col(axis).dot(position - box.center));
    }
    std::ranges::sort(along);
    box.low[axis] = quantile(along, outliers);
    box.high[axis] = quantile(along, 1.0 - outliers);
  }
  return box;
}

} // namespace dewpoint::calibration
