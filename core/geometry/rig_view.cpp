// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/rig_view.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cstddef>

namespace dewpoint::geometry {
namespace {

/// Meters before a camera, where nothing else tells what it is aimed at.
constexpr double kAhead = 2.0;

bool hasPose(const Camera& camera) {
  return camera.cameraFromWorld.matrix().allFinite();
}

/// A rig and the box around it.
struct BoxedRig {
  const CameraRig& rig;
  Eigen::AlignedBox3d box;
  double size() const { return box.diagonal().norm(); }
};

bool haveSameCameras(const BoxedRig& before, const BoxedRig& now) {
  return !before.box.isEmpty() && !now.box.isEmpty() &&
         std::ranges::equal(before.rig, now.rig, {}, &Camera::name, &Camera::name);
}

/// Whether a rig is at most so many times as large as another, and the other way around.
bool isAsLarge(const BoxedRig& before, const BoxedRig& now, double factor) {
  return now.size() <= factor * before.size() && before.size() <= factor * now.size();
}

/// How far the middle has gone, as a share of the size before.
double shiftOf(const BoxedRig& before, const BoxedRig& now) {
  return (now.box.center() - before.box.center()).norm() / before.size();
}

/// Of a rig that is calibrated as a whole, single cameras may keep their poses, too: without a
/// floor, the first one does (setup::BoardCalibrationRequest::floorFrame). Such a rig is another.
bool isOneCamera(const BoxedRig& before, const BoxedRig& now) {
  std::size_t unchanged = 0;
  for (std::size_t k = 0; k < now.rig.size(); ++k) {
    unchanged += now.rig[k].cameraFromWorld.isApprox(before.rig[k].cameraFromWorld) ? 1 : 0;
  }
  return unchanged + 1 >= now.rig.size() && isAsLarge(before, now, 1.5) &&
         shiftOf(before, now) < 0.5;
}

} // namespace

Eigen::Vector3d rigAimPoint(const CameraRig& rig) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Camera& camera : rig) {
    if (!hasPose(camera)) {
      continue;
    }
    const Eigen::Vector3d axis = camera.opticalAxis();
    const Eigen::Vector3d ahead = camera.center() + kAhead * axis;
    // The small part along the axis decides only where the axes leave it open.
    const Eigen::Matrix3d part =
        Eigen::Matrix3d::Identity() - (1.0 - 1e-3) * axis * axis.transpose();
    sum += part;
    right += part * ahead;
  }
  const Eigen::Vector3d point = sum.ldlt().solve(right);
  return point.allFinite() ? point : Eigen::Vector3d::Zero();
}

Eigen::AlignedBox3d rigBounds(const CameraRig& rig) {
  Eigen::AlignedBox3d box;
  for (const Camera& each : rig) {
    if (hasPose(each)) {
      box.extend(each.center());
    }
  }
  if (!box.isEmpty()) {
    box.extend(rigAimPoint(rig));
  }
  return box;
}

RigChange rigChange(const CameraRig& before, const CameraRig& now) {
  const BoxedRig was{before, rigBounds(before)};
  const BoxedRig is{now, rigBounds(now)};
  if (!haveSameCameras(was, is)) {
    return RigChange::Elsewhere;
  }
  if (isOneCamera(was, is)) {
    return RigChange::OneCamera;
  }
  return isAsLarge(was, is, 1.25) && shiftOf(was, is) <= 0.25 ? RigChange::Refined
                                                              : RigChange::Elsewhere;
}

} // namespace dewpoint::geometry
