// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/manual/point_pose.h"

#include "core/calibration/manual/interactive_pose.h"
#include "core/geometry/linear_algebra.h"
#include "core/geometry/ray.h"
#include "core/geometry/rotation_vector.h"

#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dewpoint::calibration {
namespace {

constexpr double kThin = 2e-3;    ///< extent over the largest: points in a line, or in a plane
constexpr double kAsGood = 2.0;   ///< of two poses: rms over the better one's, and ...
constexpr double kAsGoodPx = 1.0; ///< ... in pixels, with the noise of a click
constexpr double kBadPx = 3.0;    ///< rms: clicks are better than that

/// The three extents of a cloud of points, largest first.
Eigen::Vector3d extents(const std::vector<ImageAnchor>& anchors) {
  Eigen::Matrix3Xd all(3, static_cast<Eigen::Index>(anchors.size()));
  for (std::size_t k = 0; k < anchors.size(); ++k) {
    all.col(static_cast<Eigen::Index>(k)) = anchors[k].world;
  }
  const Eigen::Vector3d mean = all.rowwise().mean();
  all.colwise() -= mean;
  using geometry::SingularValues;
  const SingularValues svd(all, SingularValues::Vectors::None);
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  result.head(svd.values().size()) = svd.values();
  return result;
}

/// Poses that OpenCV finds for points seen along rays, in front of the camera.
std::vector<Eigen::Isometry3d> posesOf(const std::vector<cv::Point3d>& points,
                                       const std::vector<cv::Point2d>& normalized, int method) {
  std::vector<Eigen::Isometry3d> poses;
  try {
    std::vector<cv::Vec3d> turns;
    std::vector<cv::Vec3d> shifts;
    cv::solvePnPGeneric(points, normalized, cv::Matx33d::eye(), cv::noArray(), turns, shifts, false,
                        static_cast<cv::SolvePnPMethod>(method));
    for (std::size_t k = 0; k < turns.size(); ++k) {
      const Eigen::Vector3d vector(turns[k][0], turns[k][1], turns[k][2]);
      Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
      pose.linear() = rotationFromVector(vector);
      pose.translation() = Eigen::Vector3d(shifts[k][0], shifts[k][1], shifts[k][2]);
      if (pose.matrix().allFinite()) {
        poses.push_back(pose);
      }
    }
  } catch (const cv::Exception&) {
    poses.clear(); // it found none
  }
  return poses;
}

std::vector<Eigen::Isometry3d> candidates(const Camera& camera,
                                          const std::vector<ImageAnchor>& anchors, bool planar) {
  Camera lens = camera;
  lens.cameraFromWorld = Eigen::Isometry3d::Identity();
  const Unprojector unprojector(lens);
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> normalized;
  for (const ImageAnchor& anchor : anchors) {
    const auto ray = unprojector.worldDirection(anchor.pixel);
    if (!ray || !(ray->z() > 0.0)) {
      return {};
    }
    points.emplace_back(anchor.world.x(), anchor.world.y(), anchor.world.z());
    normalized.emplace_back(ray->x() / ray->z(), ray->y() / ray->z());
  }
  std::vector<Eigen::Isometry3d> all = posesOf(points, normalized, cv::SOLVEPNP_SQPNP);
  if (planar) {
    const auto both = posesOf(points, normalized, cv::SOLVEPNP_IPPE);
    all.insert(all.end(), both.begin(), both.end());
  }
  return all;
}

bool differ(const Camera& a, const Camera& b) {
  return angleBetween(a.cameraFromWorld.linear(), b.cameraFromWorld.linear()) > 0.02;
}

/// Whether a second pose explains the points about as well as the best.
bool hasSecondPose(const std::vector<PointPose>& poses) {
  return std::any_of(poses.begin() + 1, poses.end(), [&](const PointPose& other) {
    return differ(other.camera, poses.front().camera) &&
           other.rmsPx < std::max(kAsGood * poses.front().rmsPx, kAsGoodPx);
  });
}

std::vector<ImageAnchor> transformedAnchors(const ImageSymmetry& symmetry, const Camera& camera,
                                            std::vector<ImageAnchor> anchors) {
  for (ImageAnchor& anchor : anchors) {
    anchor.pixel =
        transformed(symmetry, anchor.pixel, camera.intrinsics.width, camera.intrinsics.height);
  }
  return anchors;
}

/// How far from upright a camera stands, radians; a right angle at most for one that looks steeply
/// down or up, where nobody can say.
bool isSteep(const Camera& camera) {
  return std::abs(headingOf(camera).pitch) > 60.0 * std::numbers::pi / 180.0;
}

/// All points below the camera or about its height: nobody looks up through a floor.
bool isBelowPlane(const Camera& camera, const std::vector<ImageAnchor>& anchors) {
  double highest = -std::numeric_limits<double>::infinity();
  double lowest = std::numeric_limits<double>::infinity();
  for (const ImageAnchor& anchor : anchors) {
    highest = std::max(highest, anchor.world.z());
    lowest = std::min(lowest, anchor.world.z());
  }
  const bool level = highest - lowest < 0.02;
  return level && camera.center().z() < lowest;
}

} // namespace

PointPose poseFromPoints(const Camera& camera, const std::vector<ImageAnchor>& anchors,
                         bool estimatesFocal) {
  PointPose result{camera, PoseStatus::TooFew, false, 0.0};
  if (anchors.size() < std::size_t(kFewestPointsOfPose)) {
    return result;
  }
  const Eigen::Vector3d extent = extents(anchors);
  if (extent[1] <= kThin * extent[0]) {
    result.status = PoseStatus::Collinear;
    return result;
  }
  result.arePointsCoplanar = extent[2] <= kThin * extent[0];
  std::vector<PointPose> poses;
  for (const Eigen::Isometry3d& pose : candidates(camera, anchors, result.arePointsCoplanar)) {
    PointPose found = result;
    found.camera.cameraFromWorld = pose;
    found.status = PoseStatus::None;
    if (const auto rms = refinePose(found.camera, anchors, false)) {
      found.rmsPx = *rms;
      poses.push_back(found);
    }
  }
  if (poses.empty()) {
    result.status = PoseStatus::NoPose;
    return result;
  }
  std::ranges::stable_sort(poses, {}, &PointPose::rmsPx);
  poses.front().status =
      result.arePointsCoplanar && hasSecondPose(poses) ? PoseStatus::Ambiguous : PoseStatus::None;
  if (estimatesFocal && anchors.size() >= std::size_t(kFewestPointsOfFocal)) {
    poses.front().rmsPx = refinePose(poses.front().camera, anchors, true).value_or(poses[0].rmsPx);
  }
  return poses.front();
}

WorldUprightness uprightnessOf(const PointPose& found, const std::vector<ImageAnchor>& anchors) {
  constexpr double kUpsideDown = 120.0 * std::numbers::pi / 180.0; // of roll; on its side is less
  constexpr double kClearlyBelow = 0.1; // of the distance: six degrees; level with them is not
  if (found.status == PoseStatus::NoPose || found.rmsPx > kBadPx || isSteep(found.camera)) {
    return WorldUprightness::Unknown;
  }
  const Eigen::Vector3d center = found.camera.center();
  const bool isBelow = std::ranges::all_of(anchors, [&](const ImageAnchor& anchor) {
    const Eigen::Vector3d up = anchor.world - center;
    return up.z() > kClearlyBelow * up.norm();
  });
  return isBelow && std::abs(headingOf(found.camera).roll) > kUpsideDown
             ? WorldUprightness::Inverted
             : WorldUprightness::Upright;
}

std::optional<SymmetryProposal> proposeSymmetry(const Camera& camera,
                                                const std::vector<ImageAnchor>& anchors,
                                                const PointPose& found) {
  constexpr double kBetter = 0.25; // of the rms as it is
  const bool looksBad = found.status == PoseStatus::NoPose || found.rmsPx > kBadPx;
  const double roll = headingOf(found.camera).roll;
  const bool lies = !isSteep(found.camera) && std::abs(roll) > 60.0 * std::numbers::pi / 180.0;
  const bool through = found.arePointsCoplanar && isBelowPlane(found.camera, anchors);
  if (!looksBad && !lies && !through) {
    return std::nullopt;
  }
  std::optional<SymmetryProposal> best;
  double bestRoll = std::abs(roll);
  for (const ImageSymmetry& symmetry : imageSymmetries()) {
    if (symmetry == ImageSymmetry{} || (symmetry.isMirrored && !looksBad && !through)) {
      continue;
    }
    const auto moved = transformedAnchors(symmetry, camera, anchors);
    const PointPose other = poseFromPoints(transformed(symmetry, camera), moved, false);
    const bool usable =
        other.status == PoseStatus::None || (other.status == PoseStatus::Ambiguous && through);
    const double otherRoll = std::abs(headingOf(other.camera).roll);
    if (!usable || (through && isBelowPlane(other.camera, anchors))) {
      continue;
    }
    const bool fits =
        looksBad && (found.status == PoseStatus::NoPose || other.rmsPx < kBetter * found.rmsPx);
    const bool stands = !looksBad && other.rmsPx < std::max(kBadPx, 1.5 * found.rmsPx);
    // Turns of one picture fit equally well unless its center is off: the upright one is meant.
    const bool first = !best || (other.rmsPx < 0.5 * best->rmsPx && looksBad);
    const bool upright =
        otherRoll < bestRoll - 0.5 && (!best || other.rmsPx < std::max(0.5, 2.0 * best->rmsPx));
    if ((fits || stands) && (upright || (first && (looksBad || through)))) {
      best = SymmetryProposal{symmetry, other.rmsPx, !looksBad};
      bestRoll = otherRoll;
    }
  }
  return best;
}

} // namespace dewpoint::calibration
