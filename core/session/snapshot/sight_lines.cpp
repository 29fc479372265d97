// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/snapshot/sight_lines.h"

#include "core/geometry/projector.h"
#include "core/session/snapshot/snapshot_state.h"

#include <optional>

namespace dewpoint::session {

namespace {

/// A ray ends so many times as far away as the position on it. Chosen.
constexpr double kRayEndFactor = 1.25;

std::optional<Ray> rayOf(const TrackSnapshot& snapshot, const PointClick& click) {
  const Camera* camera = cameraOf(snapshot, click.camera);
  return camera != nullptr ? Unprojector(*camera).ray(click.pixel) : std::nullopt;
}

bool isEstimateInImage(const Camera& camera, const Eigen::Vector3d& point) {
  const auto pixel = Projector(camera).project(point);
  return pixel && pixel->x() >= -0.5 && pixel->x() <= camera.intrinsics.width - 0.5 &&
         pixel->y() >= -0.5 && pixel->y() <= camera.intrinsics.height - 0.5;
}

/// What the method says of a camera; without a word, each camera is taken to see what is held.
CameraStatus statusInCamera(const TargetSnapshot& target, std::size_t camera) {
  if (camera < target.cameraReports.size()) {
    return target.cameraReports[camera].status;
  }
  const auto& evidence = cameraEvidenceOf(target.estimate);
  if (camera < evidence.size()) {
    return !evidence[camera].isInView            ? CameraStatus::OutOfView
           : evidence[camera].visibleShare > 0.0 ? CameraStatus::None
                                                 : CameraStatus::Hidden;
  }
  return isConfirmed(target.estimate) ? CameraStatus::None : CameraStatus::Hidden;
}

} // namespace

std::vector<SightLine> sightLines(const TrackSnapshot& snapshot, const TargetSnapshot& target) {
  std::vector<SightLine> lines;
  const auto position = positionOf(target.estimate);
  if (!snapshot.rig || !position || !position->mean.allFinite() ||
      particleCountOf(target.estimate) <= 0) {
    return lines;
  }
  for (std::size_t k = 0; k < snapshot.rig->size(); ++k) {
    const Camera& camera = (*snapshot.rig)[k];
    const CameraStatus status = statusInCamera(target, k);
    if (status == CameraStatus::NoImage || status == CameraStatus::OutOfView ||
        !camera.cameraFromWorld.matrix().allFinite() ||
        !isEstimateInImage(camera, position->mean)) {
      continue;
    }
    const bool sees = status == CameraStatus::None || status == CameraStatus::PartlyHidden;
    lines.push_back({static_cast<int>(k), camera.center(), position->mean, sees});
  }
  return lines;
}

std::vector<ImageLine> clickedRayLines(const TrackSnapshot& snapshot, const PointClick& click,
                                       int camera) {
  const Camera* shown = cameraOf(snapshot, camera);
  const auto ray = rayOf(snapshot, click);
  return shown != nullptr && ray && click.camera != camera ? projectRay(Projector(*shown), *ray)
                                                           : std::vector<ImageLine>();
}

std::vector<Eigen::Vector3d> clickedRayEnds(const TrackSnapshot& snapshot, const PointClick& click,
                                            const Eigen::Vector3d& position) {
  const auto ray = rayOf(snapshot, click);
  if (!ray) {
    return {};
  }
  const double length = kRayEndFactor * (position - ray->origin).norm();
  return {ray->origin, ray->origin + length * ray->direction};
}

std::vector<std::vector<Eigen::Vector3d>> dashedLine(const Eigen::Vector3d& from,
                                                     const Eigen::Vector3d& to, int count) {
  std::vector<std::vector<Eigen::Vector3d>> strokes;
  for (int k = 0; k < count; ++k) {
    const double whole = 2.0 * count - 1.0;
    strokes.push_back(
        {from + 2.0 * k / whole * (to - from), from + (2.0 * k + 1.0) / whole * (to - from)});
  }
  return strokes;
}

} // namespace dewpoint::session
