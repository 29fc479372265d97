// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/measured_points.h"
#include "core/calibration/manual/pose_change.h"

namespace dewpoint::calibration {

/// Pose of one camera from points; a step of solveFromPoints().
struct PointPose {
  Camera camera;
  PoseStatus status = PoseStatus::None;
  bool planar = false;
  double rmsPx = 0.0;
};

/// Estimates a pose by perspective-n-point without a start value, then by least squares.
PointPose poseFromPoints(const Camera& camera, const std::vector<ImageAnchor>& anchors,
                         bool alsoFocal);

/// Checks whether the images of a camera are rotated or mirrored. `found` is the result of
/// poseFromPoints() for the images as they are. A mirrored or rotated image is proposed if it fits
/// while the given one does not; a rotated one also if both fit but only then the camera is
/// upright.
std::optional<SymmetryProposal> betterSymmetry(const Camera& camera,
                                               const std::vector<ImageAnchor>& anchors,
                                               const PointPose& found);

} // namespace dewpoint::calibration
