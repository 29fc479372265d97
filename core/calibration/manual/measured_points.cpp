// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/manual/measured_points.h"

#include "core/calibration/manual/point_bundle.h"
#include "core/calibration/manual/point_pose.h"
#include "core/geometry/projector.h"
#include "core/geometry/ray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dewpoint::calibration {
namespace {

std::vector<ImageAnchor> anchorsOf(const std::vector<MeasuredPoint>& points, int camera,
                                   std::optional<int> without = std::nullopt) {
  std::vector<ImageAnchor> anchors;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const PointClick* click = findClick(points[k], camera);
    if (click != nullptr && without != static_cast<int>(k)) {
      anchors.push_back({points[k].world, click->pixel});
    }
  }
  return anchors;
}

bool isSolved(PoseStatus status) {
  return status == PoseStatus::None || status == PoseStatus::Ambiguous;
}

double rmsOf(const std::vector<ClickResidual>& residuals, const std::vector<bool>& solved) {
  double sum = 0.0;
  int count = 0;
  for (const ClickResidual& residual : residuals) {
    if (solved[static_cast<std::size_t>(residual.camera)]) {
      sum += residual.imageDistancePx * residual.imageDistancePx;
      ++count;
    }
  }
  return count > 0 ? std::sqrt(sum / count) : 0.0;
}

/// The root mean square over all solved cameras when one point is left out; nothing when too few
/// are left for the poses to be overdetermined.
std::optional<double> rmsWithout(const CameraRig& rig, const std::vector<bool>& solved,
                                 const std::vector<MeasuredPoint>& points, int without) {
  /// Points per camera that overdetermine its pose.
  constexpr std::size_t kFewest = 5;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    const auto anchors = anchorsOf(points, static_cast<int>(k), without);
    if (!solved[k]) {
      continue;
    }
    if (anchors.size() < kFewest) {
      return std::nullopt;
    }
    const PointPose pose = poseFromPoints(rig[k], anchors, false);
    if (!isSolved(pose.status)) {
      return std::nullopt;
    }
    sum += pose.rmsPx * pose.rmsPx * static_cast<double>(anchors.size());
    count += anchors.size();
  }
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, count)));
}

/// Names the worst point, and whether the rest fits without it.
void findWorst(const std::vector<bool>& solved, const std::vector<MeasuredPoint>& points,
               PointSolution& solution) {
  constexpr double kNoise = 1.0;     // pixels: a click is no better
  constexpr double kExplained = 0.4; // of the rms with it
  double largest = -1.0;             // exact points have a worst one, too
  for (const ClickResidual& residual : solution.residuals) {
    if (solved[static_cast<std::size_t>(residual.camera)] && residual.imageDistancePx > largest) {
      largest = residual.imageDistancePx;
      solution.worstPoint = residual.pointIndex;
    }
  }
  if (solution.rmsPx < kNoise) {
    return;
  }
  double least = kExplained * solution.rmsPx;
  for (int k = 0; k < static_cast<int>(points.size()); ++k) {
    const auto rms = rmsWithout(solution.rig, solved, points, k);
    if (rms && *rms < least) {
      least = *rms;
      solution.worstPoint = k;
      solution.isWorstPointWrong = true;
    }
  }
}

/// A camera with clicks, and what these say of its pose.
struct CameraClicks {
  std::size_t camera = 0;
  std::vector<ImageAnchor> anchors;
  PointPose pose;
};

/// Whether z points down, so that upright images look upside down: all cameras say so, and not only
/// one that sees points of a plane, which would look like that in a mirrored image, too.
bool zPointsDown(const std::vector<CameraClicks>& clicked) {
  std::size_t inverted = 0;
  bool inSpace = false;
  for (const CameraClicks& one : clicked) {
    const WorldUprightness side = isSolved(one.pose.status) ? uprightnessOf(one.pose, one.anchors)
                                                            : WorldUprightness::Unknown;
    if (side == WorldUprightness::Upright) {
      return false;
    }
    inverted += side == WorldUprightness::Inverted ? 1 : 0;
    inSpace = inSpace || (side == WorldUprightness::Inverted && !one.pose.arePointsCoplanar);
  }
  return inverted > 1 || inSpace;
}

} // namespace

const PointClick* findClick(const MeasuredPoint& point, int camera) {
  const auto found = std::ranges::find(point.clicks, camera, &PointClick::camera);
  return found == point.clicks.end() ? nullptr : &*found;
}

void setClickIn(MeasuredPoint& point, int camera, const Eigen::Vector2d& pixel,
                std::optional<std::int64_t> frame) {
  const auto there = std::ranges::find(point.clicks, camera, &PointClick::camera);
  if (there != point.clicks.end()) {
    there->pixel = pixel;
    there->frame = frame;
  } else {
    point.clicks.push_back({camera, pixel, frame});
  }
}

bool isClickedOnlyInOtherFrames(const MeasuredPoint& point, std::int64_t frame) {
  return !point.clicks.empty() && std::ranges::all_of(point.clicks, [&](const PointClick& click) {
    return click.frame && *click.frame != frame;
  });
}

std::vector<ClickResidual> clickResiduals(const CameraRig& rig,
                                          const std::vector<MeasuredPoint>& points) {
  std::vector<ClickResidual> residuals;
  for (std::size_t camera = 0; camera < rig.size(); ++camera) {
    const Projector projector(rig[camera]);
    const Unprojector unprojector(rig[camera]);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const PointClick* click = findClick(points[k], static_cast<int>(camera));
      if (click == nullptr) {
        continue;
      }
      const auto seen = projector.project(points[k].world);
      const auto ray = unprojector.ray(click->pixel);
      constexpr double kNever = std::numeric_limits<double>::infinity();
      residuals.push_back({static_cast<int>(k), static_cast<int>(camera),
                           seen ? (*seen - click->pixel).norm() : kNever,
                           ray ? distanceToRay(*ray, points[k].world) : kNever});
    }
  }
  std::ranges::stable_sort(residuals, {}, &ClickResidual::pointIndex);
  return residuals;
}

bool PointSolution::hasSolvedCamera() const {
  return std::ranges::any_of(
      cameras, [](const CameraFromPoints& camera) { return isSolved(camera.status); });
}

PointSolution solveFromPoints(const CameraRig& rig, const std::vector<MeasuredPoint>& points,
                              const PointSettings& settings) {
  PointSolution solution;
  solution.rig = rig;
  std::vector<bool> solved(rig.size(), false);
  std::vector<CameraClicks> clicked;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    auto anchors = anchorsOf(points, static_cast<int>(k));
    if (!anchors.empty()) {
      const PointPose pose = poseFromPoints(rig[k], anchors, settings.estimatesFocal);
      clicked.push_back({k, std::move(anchors), pose});
    }
  }
  const bool isInverted = zPointsDown(clicked);
  for (const auto& [k, anchors, pose] : clicked) {
    CameraFromPoints camera{static_cast<int>(k), static_cast<int>(anchors.size()), pose.status,
                            pose.rmsPx, std::nullopt};
    if (isSolved(pose.status)) {
      solution.rig[k] = pose.camera;
      solved[k] = true;
    }
    const bool isExplained = isInverted && isSolved(pose.status) &&
                             uprightnessOf(pose, anchors) == WorldUprightness::Inverted;
    if ((isSolved(pose.status) && !isExplained) || pose.status == PoseStatus::NoPose) {
      camera.proposal = proposeSymmetry(rig[k], anchors, pose);
    }
    solution.cameras.push_back(camera);
  }
  if (std::ranges::count(solved, true) > 1) {
    refineCamerasAndPoints(solution.rig, solved, points, settings);
  }
  solution.residuals = clickResiduals(solution.rig, points);
  solution.rmsPx = rmsOf(solution.residuals, solved);
  findWorst(solved, points, solution);
  return solution;
}

} // namespace dewpoint::calibration
